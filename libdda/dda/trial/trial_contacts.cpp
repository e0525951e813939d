#include "dda/trial/trial_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/contact/detect.hpp"
#include "dda/trial/joint_motion.hpp"
#include "dda/trial/single_strength.hpp"

namespace rockslope::dda {

namespace {

/// Whether an elastic shear force is within the bounds, so that the contact is locked. A contact with zero
/// bounds is never locked.
bool is_within(double force, const Strength& bounds) {
    return force <= bounds.forward && force >= -bounds.backward && bounds.forward + bounds.backward > 0;
}

}  // namespace

TrialContacts::TrialContacts(const StepProblem& problem, const ThreadPool& pool,
                             PerContact<ContactTrial> memory)
    : p_(problem), pool_(pool), trials_(std::move(memory)), bolts_(problem) {
    trials_.resize(problem.contacts.size());
    for_each([&](ContactIndex k) { trials_[k] = initial_trial(k); });
}

ContactTrial TrialContacts::initial_trial(ContactIndex k) const {
    const Contact& contact = p_.contacts[k];
    ContactTrial trial;
    trial.has_cohesion = has_cohesion(law_of(k)) && contact.length > 0;
    if (p_.bonds_hold() && contact.bonded) trial.tensile_strength = single_strength(p_, k, {}).tensile;
    trial.may_close = !contact.inhibited;
    trial.gap_offset = contact.gap;
    trial.stress_free_gap = contact.stress_free_gap;
    trial.shear_origin = contact.shear_force;
    const bool was_closed = contact.state != ContactState::open;
    trial.coheres = was_closed && trial.has_cohesion;
    // A bond that has just got a contact bears tension from the start.
    trial.has_normal_spring =
        trial.may_close && (was_closed || contact.bonded || (contact.gap < 0 && contact.group < 0));
    trial.has_shear_spring = trial.has_normal_spring && contact.state != ContactState::sliding;
    trial.friction_force = contact.shear_force;
    trial.slides_forward = contact.shear_force >= 0;
    trial.held_normal = contact.normal_force;
    trial.dilating = locked_dilation(p_.model, contact.joint_material, contact.history);
    trial.shear_origin -= trial.dilating.shear_force(contact.normal_force, contact.joint_share);
    trial.tilt = trial.sliding_slope = trial.dilating.slope;
    trial.dilation_increment = left_dilation(p_.model, contact);
    if (const EvaluatedContact* guess = p_.guess[k]; guess != nullptr && trial.may_close) {
        trial.has_normal_spring = guess->state != ContactState::open;
        trial.has_shear_spring = guess->state == ContactState::locked;
        trial.friction_force = guess->shear_force;
        trial.slides_forward = guess->shear_force >= 0;
        trial.dilation_increment = guess->dilation_increment;  // at the shearing of the guess
        trial.shearing = guess->displacement;
        trial.held_normal = std::max(guess->normal_force, 0.0);
    }
    trial.friction_force -= trial.tilt * trial.held_normal;
    trial.tangent = tangent_at(k, trial.has_normal_spring ? initial_spring_force(k) : 0);
    return trial;
}

ContactLoading TrialContacts::initial_loading(ContactIndex k) const {
    if (const EvaluatedContact* guess = p_.guess[k]; guess != nullptr)
        return {guess->normal_force, guess->displacement};
    return {p_.contacts[k].normal_force, 0};
}

double TrialContacts::initial_spring_force(ContactIndex k) const {
    const EvaluatedContact* guess = p_.guess[k];
    return guess != nullptr ? guess->normal_spring_force : p_.contacts[k].normal_spring_force;
}

NormalTangent TrialContacts::tangent_at(ContactIndex k, double spring_force) const {
    const NormalClosure& spring = p_.springs[k].normal_law;
    const NormalDashpot beside = dashpot(k);
    const double compression = spring.is_linear() ? 0 : std::max(spring_force, 0.0);
    NormalTangent tangent{0, 0, spring.stiffness};
    if (!spring.is_linear())
        tangent = {spring.closure(compression), compression, spring.tangent(compression)};
    if (beside.stiffness > 0) {
        tangent.force += beside.force(tangent.point);
        tangent.stiffness += beside.stiffness;
    }
    return tangent;
}

// --- the iterate

void TrialContacts::set_displacement(RowSpan<const Vec6> d, RowSpan<const Vec6> target, Gaps gaps) {
    evaluated_ = true;
    for_each([&](ContactIndex k) {
        const Vec2 balanced = p_.springs[k].rows.relative_displacement(target);
        ContactTrial& trial = trials_[k];
        trial.linear = linear_forces(k, normal_measure(k).at(balanced), p_.springs[k].shear.at(balanced));
        trial.linear.shear += trial.tilt * trial.linear.normal;
    });
    bolts_.set_target(target);
    move_to(d);
    if (gaps == Gaps::exact) measure_gaps(d);
}

/// The offsets of Eq. (21).
void TrialContacts::measure_gaps(RowSpan<const Vec6> d) {
    const Topology& topology = p_.model.topology;
    moved_vertices_.resize(p_.blocks.vertices.size());
    pool_.parallel_for(p_.prescribed.size(), [&](std::size_t begin, std::size_t end) {
        for (const BlockIndex b : indices<BlockIndex>(begin, end)) {
            const RowIndex row = p_.rows.row_of[b];
            const BlockMap map(p_.blocks.moments[b].centroid, row.exists() ? d[row] : p_.prescribed[b]);
            for (const CornerIndex c : topology.corners_of(b))
                moved_vertices_[c] = map(p_.blocks.vertices[c]);
        }
    });
    for_each([&](ContactIndex k) {
        const Contact& contact = p_.contacts[k];
        ContactTrial& trial = trials_[k];
        const CornerEdgeGeometry geometry =
            corner_edge_geometry(moved_vertices_[contact.corner], moved_vertices_[start_of(contact.edge)],
                                 moved_vertices_[topology.end_of(contact.edge)]);
        // The gap less its linear measure, Eq. (21).
        trial.gap_offset = geometry.gap - contact.dilation - trial.opening - trial.tilt * trial.shearing;
    });
}

void TrialContacts::move_to(RowSpan<const Vec6> d) {
    for_each([&](ContactIndex k) {
        const ContactSprings& s = p_.springs[k];
        ContactTrial& trial = trials_[k];
        const Vec2 relative_displacement = s.rows.relative_displacement(d);
        const double shearing = s.shear.at(relative_displacement);
        // The linearised dilation continues to the new iterate.
        trial.dilation_increment += trial.tilt * (shearing - trial.shearing);
        trial.opening = normal_measure(k).at(relative_displacement);
        trial.shearing = shearing;
    });
    bolts_.move_to(d);
}

TrialContacts::ForceChange TrialContacts::force_change() {
    struct Largest {
        ForceChange change;
        double force = 0;  ///< largest force of a law
    };
    const auto largest_of_chunk = [&](std::size_t begin, std::size_t end) {
        Largest found;
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const Forces law = law_forces(k);
            const Forces& linear = trials_[k].linear;
            const double normal = std::abs(law.normal - linear.normal);
            const double shear = std::abs(law.shear - linear.shear);
            const double difference = std::isfinite(normal + shear) ? std::max(normal, shear)
                                                                    : std::numeric_limits<double>::infinity();
            found.force = std::max({found.force, std::abs(law.normal), std::abs(law.shear)});
            if (difference > found.change.largest) found.change = {difference, k};
        }
        return found;
    };
    const auto larger = [](const Largest& a, const Largest& b) {
        return Largest{b.change.largest > a.change.largest ? b.change : a.change, std::max(a.force, b.force)};
    };
    const Largest largest = pool_.parallel_reduce(count(), Largest(), largest_of_chunk, larger);
    largest_force_ = largest.force;
    ForceChange change = largest.change;
    change.largest = std::max(change.largest, bolts_.force_change());
    return change;
}

/// The convergence tolerance, Eq. (36).
double TrialContacts::tolerance() const {
    return std::max(p_.control.force_tolerance * largest_force_, p_.rounding_force);
}

/// The elastic shear force of Eq. (23); it follows the normal force where the joint dilates, Eq. (77).
double TrialContacts::elastic_shear(ContactIndex k) const {
    const ContactTrial& trial = trials_[k];
    const double spring = trial.shear_origin + p_.springs[k].shear_stiffness * trial.shearing;
    return trial.dilating.slope == 0 ? spring : spring + by_slope(k);
}

double TrialContacts::by_slope(ContactIndex k) const {
    return trials_[k].dilating.shear_force(std::max(law_forces(k).normal, 0.0), p_.contacts[k].joint_share);
}

bool TrialContacts::update_active_set(Tilts tilts) {
    const bool contacts = for_any([&](ContactIndex k) { return update_active_set_of(k, tilts); });
    const bool bolts = bolts_.update_active_set();
    return contacts || bolts;
}

TrialContacts::ShearState TrialContacts::shear_state(ContactIndex k, Tilts tilts) const {
    const ContactTrial& trial = trials_[k];
    const double elastic = elastic_shear(k);
    if (tilts == Tilts::follow)
        return {trial.may_close && is_within(elastic, trial.bounds_here()), elastic >= 0};
    const ContactLaw held = law(k);
    const ShearPiece piece = held.shear_piece(trial.shearing);
    return {held.locks(trial.shearing),
            piece == ShearPiece::locked ? elastic >= 0 : piece == ShearPiece::forward};
}

bool TrialContacts::update_active_set_of(ContactIndex k, Tilts tilts) {
    ContactTrial& trial = trials_[k];
    const Forces law = law_forces(k);
    const ShearState shear = shear_state(k, tilts);
    const bool active = trial.may_close && law.normal > least_normal_force(k);
    bool changed = active != trial.has_normal_spring || shear.locked != trial.has_shear_spring;
    if (active && std::abs(law.normal - trial.linear.normal) > tolerance()) {
        const NormalTangent tangent = tangent_at(k, spring_force(k));
        changed = changed || tangent.stiffness != trial.tangent.stiffness;
        trial.tangent = tangent;
    }
    trial.has_normal_spring = active;
    trial.has_shear_spring = shear.locked;
    const double tilt = shear.locked ? trial.dilating.slope : trial.sliding_slope;
    if (tilts == Tilts::follow && tilt != trial.tilt) {
        trial.set_tilt(tilt);
        changed = changed || active;
    }
    trial.slides_forward = shear.slides_forward;
    const double stiffness = active && !shear.locked ? trial.hardening_ahead() : 0;
    changed = changed || stiffness != trial.sliding_stiffness;
    trial.sliding_stiffness = stiffness;
    trial.friction_force = law.shear - trial.tilt * law.normal - stiffness * trial.shearing;
    return changed;
}

double TrialContacts::slip(ContactIndex k, double elastic, double force) const {
    const Strength bounds = trials_[k].bounds_here();
    if (is_within(elastic, bounds)) return 0;
    if (!p_.model.is_augmented(p_.contacts[k].joint_material)) {
        // The spring bears nothing of what is too steep for the strength.
        const double climbing = by_slope(k);
        const double climbed = std::clamp(climbing, -bounds.backward, bounds.forward);
        return (elastic - (climbing - climbed) - force) / p_.springs[k].shear_stiffness;
    }
    if (elastic == force) return 0;
    return force >= 0 ? std::max(trials_[k].shearing, 0.0) : std::min(trials_[k].shearing, 0.0);
}

ContactMotion TrialContacts::motion(ContactIndex k) const {
    const double slipped = slip(k, elastic_shear(k), law_forces(k).shear);
    ContactMotion motion = contact_motion(p_.model, p_.contacts[k], p_.springs[k].shear_stiffness,
                                          law_forces(k).normal, trials_[k].shearing, slipped);
    motion.time = p_.time;
    return motion;
}

void TrialContacts::evaluate(ContactSpan<EvaluatedContact> evaluated_contacts) const {
    for_each([&](ContactIndex k) { evaluated_contacts[k] = evaluated(k); });
}

/// The opening of Eq. (76).
bool TrialContacts::stays_closed(ContactIndex k) const {
    const ContactTrial& trial = trials_[k];
    if (!trial.may_close) return false;
    if (is_bonded(k) || law_forces(k).normal > 0 || is_rebounding(k)) return true;
    if (p_.bonds_hold() && coheres(k)) return trial.gap() < largest_bond_strain * p_.contacts[k].length;
    return coheres(k) && -spring_force(k) < std::min(trial.bounds.forward, trial.bounds.backward);
}

EvaluatedContact TrialContacts::evaluated(ContactIndex k) const {
    const ContactTrial& trial = trials_[k];
    const Forces forces = law_forces(k);
    EvaluatedContact evaluated;
    evaluated.gap = trial.gap();
    evaluated.normal_force = forces.normal;
    evaluated.normal_spring_force =
        dashpot(k).stiffness > 0 && trial.may_close ? std::max(spring_force(k), 0.0) : forces.normal;
    const bool is_pressed = forces.normal > 0 || evaluated.normal_spring_force > 0;
    const bool is_held = stays_closed(k) && (is_bonded(k) || coheres(k));
    evaluated.stress_free_gap =
        is_pressed || is_held ? trial.stress_free_gap : std::min(trial.stress_free_gap, 0.0);
    evaluated.shear_force = forces.shear;
    evaluated.displacement = trial.shearing;
    evaluated.dilation_increment = trial.dilation_increment;
    evaluated.bond_broken = trial.bond_broken;
    if (stays_closed(k)) {
        const double elastic = elastic_shear(k);
        evaluated.state =
            is_within(elastic, trial.bounds_here()) ? ContactState::locked : ContactState::sliding;
        if (!is_rebounding(k) || coheres(k)) evaluated.slip = slip(k, elastic, forces.shear);
    }
    return evaluated;
}

}  // namespace rockslope::dda
