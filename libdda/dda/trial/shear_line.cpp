#include "dda/trial/shear_line.hpp"

namespace rockslope::dda {

ShearLine shear_line(const StepProblem& problem, const TrialContacts& trials, ContactIndex k, double normal,
                     RowSpan<const Vec6> d) {
    const Contact& contact = problem.contacts[k];
    const bool bonded = trials.is_bonded(k);
    const bool coheres = trials.coheres(k);
    ShearLine shear;
    if (const auto line = bound_line(trials.law_of(k), contact.history)) {
        const double reduced = 1 / problem.model.strength_reduction;
        const double held = problem.bonds_hold() ? problem.held_shares[k] * reduced : reduced;
        shear.slope = reduced * line->friction;
        shear.cohesion = coheres || bonded ? held * line->cohesion * contact.length : 0;
        shear.lowest_normal_force = trials.least_normal_force(k);
        return shear;
    }
    if (trials.is_on_segment(k)) {
        const BoundLine line = trials.bound_tangent(k);
        shear.is_missing = !trials.has_line(k);
        shear.slope = line.slope;
        shear.cohesion = line.cohesion;
        return shear;
    }
    if (!(normal > 0) && !bonded && !coheres) {
        shear.slope = trials.bound_secant(k);
        return shear;
    }
    shear.cohesion = trials.bound_at(k, normal, d);
    if (!(normal > 0)) return shear;
    const double half = normal / 2;
    shear.slope = (shear.cohesion - trials.bound_at(k, half, d)) / half;
    shear.cohesion -= shear.slope * normal;
    return shear;
}

}  // namespace rockslope::dda
