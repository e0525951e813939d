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
    /// @param tolerance N per metre, of forces; small changes always settle or are left to the iteration.
    /// @return whether the gaps do not settle.
    bool fails(double change, double tolerance) {
        const bool is_large = change > change_over_tolerance * tolerance;
        const bool fails = is_large && change > contraction * last_;
        last_ = change;
        return fails;
    }

  private:
    /// Changes of fewer tolerances are left to the iteration: with one tolerance a wall of Voronoi cells is
    /// cut 7800 times.
    static constexpr double change_over_tolerance = 1e3;
    static constexpr double contraction = 0.5;  ///< largest ratio of a change to the one before that settles
    double last_ = std::numeric_limits<double>::infinity();
};

}  // namespace rockslope::dda
