#include "dda/joint/elastic.hpp"

#include <algorithm>
#include <limits>

namespace rockslope::dda {

namespace {

/// Friction coefficient of faces that meet later, 87 degrees: steep enough that they do not slip. It is
/// finite, so the shear force vanishes with the normal force.
constexpr double friction_of_later_contact = 20;

}  // namespace

Strength Elastic::strength(const History& history, double normal_force, double, const ShearTrial&) const {
    // The strengths of Eq. (45).
    const double unbounded = std::numeric_limits<double>::infinity();
    if (history.bonded) return {unbounded, unbounded, unbounded};
    const double shear = friction_of_later_contact * std::max(normal_force, 0.0);
    return {shear, shear, 0};
}

}  // namespace rockslope::dda
