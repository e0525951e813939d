#pragma once

#include <limits>

namespace rockslope::dda {

/// Tells where small patches no longer get nearer to balance: they pass an unbalanced force on to each other,
/// or the linear solution of all blocks brings it back each time.
class BalanceProgress {
  public:
    /// Notes the largest unbalanced force of an iteration, N per metre.
    void note(double unbalanced) {
        if (unbalanced <= progress * best_) {
            best_ = unbalanced;
            without_ = 0;
        } else {
            ++without_;
        }
    }
    /// Whether the force has not halved in the last iterations.
    bool has_stalled() const { return without_ >= most_without; }
    /// Begins anew: the next force is the first.
    void restart() { *this = {}; }

  private:
    static constexpr double progress = 0.5;
    static constexpr int most_without = 2;

    double best_ = std::numeric_limits<double>::infinity();  ///< N per metre, at the last progress
    int without_ = 0;                                        ///< iterations since then
};

}  // namespace rockslope::dda
