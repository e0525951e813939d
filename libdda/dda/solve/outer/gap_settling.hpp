#pragma once

#include <limits>

namespace rockslope::dda {

/// Watches the patch iterations, which find minima for gaps that are linear in the displacement, Eq. (20),
/// and evaluate the gaps exactly there, Eq. (21). About the right mid-step both agree to third order, and
/// each minimum changes the forces less than the one before. Where the forces change as much again, blocks
/// turn otherwise than predicted, and no number of iterations settles their gaps.
class GapSettling {
  public:
    /// @param change N per metre, the largest change of a force as the gaps follow a minimum.
    /// @param tolerance N per metre, of forces; smaller changes are settled.
    /// @return whether the gaps do not settle.
    bool fails(double change, double tolerance) {
        const bool is_slow = change > tolerance && change > contraction * last_;
        slow_ = is_slow ? slow_ + 1 : 0;
        last_ = change;
        return is_slow && (change > change_over_tolerance * tolerance || slow_ == slow_limit);
    }

  private:
    /// Changes of fewer tolerances are left to the iteration: with one tolerance a wall of Voronoi cells is
    /// cut 7800 times.
    static constexpr double change_over_tolerance = 1e3;
    static constexpr double contraction = 0.5;  ///< largest ratio of a change to the one before that settles
    /// Small changes, too, settle no more after so many in a row that hardly contract: a wedge that is about
    /// to jam moves far for a small force, and the error of its rotation with it.
    static constexpr int slow_limit = 4;
    int slow_ = 0;  ///< changes in a row that hardly contracted
    double last_ = std::numeric_limits<double>::infinity();
};

}  // namespace rockslope::dda
