#include "dda/solve/methods/limited_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockslope::dda {

namespace {

/// A shear bound that hardens: a line over the normal force through no force, and the part of the
/// elastic shear force beyond it that the contact bears. The line goes through no force so that the pieces of
/// the contact meet where it opens.
struct HardeningBound {
    double slope = 0;
    double part = 0;
};

/// The bound of Eq. (103). @param ratio of bound and normal force there;
/// @param elastic the elastic shear force over the normal force, positive in the direction of the bound;
/// @param growth of the bound over that of the elastic shear force, below 1.
HardeningBound hardening_bound(double ratio, double elastic, double growth) {
    if (!(elastic > 0)) return {ratio, 0};
    const double part = std::min(growth, ratio / elastic);
    return {(ratio - part * elastic) / (1 - part), part};
}

/// Sets the bounds of a contact on a rough joint segment. @param ratio of bounds and normal force.
void set_segment_bounds(const ContactTrial& trial, const ContactLaw& law, const Strength& ratio,
                        LimitedContact& contact) {
    HardeningBound forward{ratio.forward, 0};
    HardeningBound backward{ratio.backward, 0};
    if (trial.held_normal > 0 && trial.hardening.any()) {
        const double elastic = law.elastic(trial.held_shearing) / trial.held_normal + trial.tilt;
        const double stiffness = law.shear_stiffness;
        forward = hardening_bound(ratio.forward, elastic, trial.hardening.forward / stiffness);
        backward = hardening_bound(ratio.backward, -elastic, trial.hardening.backward / stiffness);
    }
    contact.forward.slope = forward.slope;
    contact.backward.slope = backward.slope;
    contact.hardening = {forward.part, backward.part};
}

/// Sets the shear bounds. @param normal N per metre, the normal force at d.
void set_bounds(const TrialContacts& trials, const ShearBounds& bounds, ContactIndex k, double normal,
                RowSpan<const Vec6> d, LimitedContact& contact) {
    const bool has_strength_alone = trials.is_bonded(k) || trials.coheres(k);
    if (bounds.is_on_segment(k)) {
        set_segment_bounds(trials[k], trials.law(k), bounds.over_normal_force(k), contact);
        return;
    }
    const ShearLine line = bounds.line(k, normal, d);
    ForceLine bound{line.cohesion, std::max(line.slope, 0.0)};
    if (!has_strength_alone) bound = {0, normal > 0 ? line.at(normal) / normal : bound.slope};
    contact.forward = contact.backward = bound;
    if (!trials.is_bonded(k)) return;
    contact.floor = std::max(line.lowest_normal_force, contact.least_normal);
    if (bound.slope > 0) contact.floor = std::max(contact.floor, -bound.cohesion / bound.slope);
    if (!std::isfinite(contact.floor)) contact.floor = 0;
}

LimitedContact limited_contact(const StepProblem& problem, const TrialContacts& trials,
                               const ShearBounds& bounds, ContactIndex k, RowSpan<const Vec6> d) {
    const ContactSprings& springs = problem.springs[k];
    LimitedContact contact;
    contact.rows = &springs.rows;
    contact.may_close = trials[k].may_close;
    if (!contact.may_close) return contact;
    const RelativeMeasure opening = trials.normal_measure(k);
    const ContactLaw law = trials.law(k);
    const double spring_force = law.spring_force(springs.rows.measure(opening, d));
    const TrialContacts::SpringForce normal = trials.normal_tangent(k, spring_force, opening.prescribed);
    contact.opening = opening.direction;
    contact.shearing = springs.shear.direction;
    contact.normal_stiffness = normal.stiffness;
    contact.shear_stiffness = springs.shear_stiffness;
    contact.origin = {normal.force, law.shear_origin + springs.shear_stiffness * springs.shear.prescribed};
    contact.least_normal = trials.least_normal_force(k);
    contact.tilt = trials[k].tilt;
    const double present = contact.elastic_at(d).normal;
    set_bounds(trials, bounds, k, std::max(present, contact.least_normal), d, contact);
    return contact;
}

/// A bolt as a contact without a normal spring, whose shear spring is along the bolt, Eq. (38).
LimitedContact limited_bolt(const StepProblem& problem, std::size_t k) {
    const BoltSpring& bolt = problem.bolts[k];
    const double yield_force = problem.model.bolts[k].yield_force;
    LimitedContact contact;
    contact.rows = &bolt.rows;
    contact.shearing = bolt.elongation.direction;
    contact.shear_stiffness = bolt.stiffness;
    contact.origin.shear = problem.bolt_force[k] + bolt.stiffness * bolt.elongation.prescribed;
    const double bound = yield_force > 0 ? yield_force : std::numeric_limits<double>::infinity();
    contact.forward = contact.backward = {bound, 0};
    return contact;
}

}  // namespace

void limit_contacts(const StepProblem& problem, const TrialContacts& trials, const ShearBounds& bounds,
                    RowSpan<const Vec6> d, const ThreadPool& pool, PerContact<LimitedContact>& contacts) {
    contacts.resize(trials.count() + problem.bolts.size());
    pool.parallel_for(trials.count(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end))
            contacts[k] = limited_contact(problem, trials, bounds, k, d);
    });
    for (std::size_t k = 0; k < problem.bolts.size(); ++k)
        contacts[ContactIndex(trials.count() + k)] = limited_bolt(problem, k);
}

}  // namespace rockslope::dda
