#pragma once

#include <algorithm>

#include "dda/contact/contact.hpp"

namespace rockslope::dda {

/// The distance within which a corner and an edge may meet in a step: that of a pair without relative motion,
/// plus a multiple of the relative motion that is predicted. A pair farther apart is not visited in the step.
class SearchRadius {
  public:
    /// The same distance, m, for all pairs.
    SearchRadius(double radius = 0) : at_rest_(radius), largest_(radius) {}
    /// @param at_rest m, of a pair without relative motion. @param largest_motion m, by which any corner is
    /// predicted to move. @param limit m, not below at_rest: no pair gets more.
    SearchRadius(double at_rest, double largest_motion, double limit)
        : at_rest_(at_rest), largest_(std::min(at_rest + motion_factor * largest_motion, limit)) {}

    /// The distance, m, of a pair. @param relative_motion m, predicted.
    double of(double relative_motion) const {
        return std::min(at_rest_ + motion_factor * relative_motion, largest_);
    }
    /// The distance, m, that no pair exceeds.
    double largest() const { return largest_; }
    /// Makes the largest distance at least `radius`, m, by as much as pairs at rest get more.
    void widen(double radius) {
        if (radius <= largest_) return;
        at_rest_ += radius - largest_;
        largest_ = radius;
    }

  private:
    static constexpr double motion_factor = 3;
    double at_rest_;
    double largest_;
};

/// What a step is expected to move, m.
struct ExpectedMotion {
    double motion = 0;    ///< the largest displacement of a corner at its velocity
    double change = 0;    ///< by which gravity may change the distance of a pair
    double limit = 0;     ///< a step in which a corner moves farther is rejected
    double rounding = 0;  ///< added to every distance
};

/// The search radius that a step begins with: the expected motion, beyond the present penetrations and
/// dilations.
SearchRadius initial_search_radius(ContactSpan<const Contact> contacts, const ExpectedMotion& expected);

}  // namespace rockslope::dda
