#pragma once

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// The shear bound of a contact, in its sliding direction, as a line over its normal force.
struct ShearLine {
    double slope = 0;
    double cohesion = 0;             ///< N per metre, bound at zero normal force
    double lowest_normal_force = 0;  ///< N per metre, the normal force below which the bound falls no further
    bool is_missing = false;         ///< its joint segment has to compute it first

    double at(double normal) const { return slope * std::max(normal, lowest_normal_force) + cohesion; }
};

/// The shear line of a contact: the law's own where it has one; on a joint segment the tangent at the last
/// evaluation; otherwise the secant between a normal force and half of it. An unbonded contact without a
/// normal force there gets the secant from zero to the last evaluation.
/// @param normal N per metre, the normal force; @param d per row, the displacement at which the law is
/// evaluated.
ShearLine shear_line(const StepProblem& problem, const TrialContacts& trials, ContactIndex k, double normal,
                     RowSpan<const Vec6> d);

}  // namespace rockslope::dda
