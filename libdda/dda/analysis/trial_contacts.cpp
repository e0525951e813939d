#include "dda/analysis/trial_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "dda/analysis/joint_motion.hpp"
#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

/// Whether the joint bears an elastic shear force without slipping. Without strength nothing is locked.
bool is_within(double force, const Strength& bounds) {
    return force <= bounds.forward && force >= -bounds.backward && bounds.forward + bounds.backward > 0;
}

/// Of the force tolerance: what the normal force of a dilation may be off by at the end of a step. It acts
/// from the next one on.
constexpr double dilation_tolerance = 10;

/// Of the force tolerance: where less has moved since, the laws of rough faces are not asked again but for
/// what is taken for converged.
constexpr double law_reuse_tolerance = 0.1;

}  // namespace

TrialContacts::TrialContacts(const StepProblem& problem, const ThreadPool& pool)
    : p_(problem), pool_(pool), segment_friction_(problem, pool), trials_(problem.contacts.size()) {
    for_contacts([&](std::size_t k) { trials_[k] = initial_trial(k); });
    for (const Contact& contact : p_.contacts)
        groups_ = std::max(groups_, static_cast<std::size_t>(contact.group + 1));
    dilates_ = std::any_of(p_.model.joint_materials.begin(), p_.model.joint_materials.end(),
                           [](const JointMaterial& material) { return dilates(material.law); });
    yielding_.assign(p_.bolts.size(), 0);
    elongation_.assign(p_.bolts.size(), 0);
    linear_bolt_.assign(p_.bolts.size(), 0);
}

template <class Body>
void TrialContacts::for_contacts(const Body& body) const {
    pool_.parallel_for(count(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) body(k);
    });
}

template <class IsOne>
bool TrialContacts::for_any_contact(const IsOne& is_one) const {
    const auto any_in_chunk = [&](std::size_t begin, std::size_t end) {
        bool any = false;
        for (std::size_t k = begin; k < end; ++k) any = is_one(k) || any;
        return any;
    };
    return pool_.parallel_reduce(count(), false, any_in_chunk, std::logical_or<>());
}

TrialContacts::Trial TrialContacts::initial_trial(std::size_t k) const {
    const Contact& contact = p_.contacts[k];
    Trial trial;
    trial.may_close = !contact.inhibited;
    trial.gap_offset = contact.gap;
    trial.stress_free_gap = contact.stress_free_gap;
    trial.shear_origin = contact.shear_force;
    const bool was_closed = contact.state != ContactState::open;
    trial.active = trial.may_close && (was_closed || (contact.gap < 0 && contact.group < 0));
    trial.locked = trial.active && contact.state != ContactState::sliding;
    trial.friction_force = contact.shear_force;
    trial.forward = contact.shear_force >= 0;
    if (const EvaluatedContact* guess = p_.guess[k]; guess != nullptr && trial.may_close) {
        trial.active = guess->state != ContactState::open;
        trial.locked = guess->state == ContactState::locked;
        trial.friction_force = guess->shear_force;
        trial.forward = guess->shear_force >= 0;
        trial.dilation_increment = guess->dilation_increment;
    }
    if (trial.active && !trial.locked && !is_on_segment(k))
        trial.bounds = bounds_of_single_contact(k, initial_loading(k));
    trial.tangent = tangent_at(k, trial.active ? initial_loading(k).normal : 0);
    return trial;
}

ContactLoading TrialContacts::initial_loading(std::size_t k) const {
    if (const EvaluatedContact* guess = p_.guess[k]; guess != nullptr)
        return {guess->normal_force, guess->displacement};
    return {p_.contacts[k].normal_force, 0};
}

Strength TrialContacts::bounds_of_single_contact(std::size_t k, const ContactLoading& loading) const {
    const ContactMotion motion = contact_motion(p_.model, p_.contacts[k], p_.springs[k].shear_stiffness,
                                                loading.normal, loading.shearing, 0);
    const Strength strengths = strength(law_of(k), p_.contacts[k].history, motion.normal_force, motion.length,
                                        {motion.displacement, motion.shear_force, motion.stiffness});
    const double reduced = 1 / p_.model.strength_reduction;
    return {strengths.forward * reduced, strengths.backward * reduced, strengths.tensile * reduced};
}

// --- the linear system

double TrialContacts::linear_bolt_force(std::size_t k, double elongation) const {
    return yielding_[k] == 0 ? p_.bolt_force[k] + p_.bolts[k].stiffness * elongation
                             : yielding_[k] * p_.model.bolts[k].yield_force;
}

// --- the laws

Forces TrialContacts::current_forces(std::size_t k) const {
    return law_forces(k, trials_[k].opening, trials_[k].shearing);
}

TrialContacts::Tangent TrialContacts::tangent_at(std::size_t k, double force) const {
    const NormalClosure& spring = p_.springs[k].normal_law;
    if (spring.is_linear()) return {0, 0, spring.stiffness};
    const double compression = std::max(force, 0.0);
    return {spring.closure(compression), compression, spring.tangent(compression)};
}

double TrialContacts::law_bolt_force(std::size_t k, double elongation) const {
    const double elastic = p_.bolt_force[k] + p_.bolts[k].stiffness * elongation;
    const double yield = p_.model.bolts[k].yield_force;
    return yield > 0 ? std::clamp(elastic, -yield, yield) : elastic;
}

// --- the shear forces of sliding contacts

void TrialContacts::find_requested_lines() {
    segment_friction_.find_requested_lines(
        [this](std::size_t k) { return evaluated_ ? current_loading(k) : initial_loading(k); });
}

void TrialContacts::set_bound_to_friction_force(std::size_t k) {
    Trial& trial = trials_[k];
    (trial.forward ? trial.bounds.forward : trial.bounds.backward) = std::abs(trial.friction_force);
}

double TrialContacts::bound_at(std::size_t k, double normal, std::span<const Vec6> d) const {
    const ContactSprings& s = p_.springs[k];
    return in_direction(k, bounds_of_single_contact(k, {normal, s.rows.measure(s.shear, d)}));
}

// --- evaluation

void TrialContacts::set_displacement(std::span<const Vec6> d, std::span<const Vec6> target) {
    evaluated_ = true;
    const Topology& topology = p_.model.topology;
    moved_vertices_.resize(p_.blocks.vertices.size());
    pool_.parallel_for(p_.prescribed.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            const int row = p_.rows.row_of[b];
            const BlockMap map(p_.blocks.moments[b].centroid,
                               row < 0 ? p_.prescribed[b] : d[static_cast<std::size_t>(row)]);
            for (int c = topology.block_corners[b]; c < topology.block_corners[b + 1]; ++c)
                moved_vertices_[static_cast<std::size_t>(c)] =
                    map(p_.blocks.vertices[static_cast<std::size_t>(c)]);
        }
    });
    const auto moved = [&](int corner) -> const Vec2& {
        return moved_vertices_[static_cast<std::size_t>(corner)];
    };
    for_contacts([&](std::size_t k) {
        const Contact& contact = p_.contacts[k];
        const ContactSprings& s = p_.springs[k];
        Trial& trial = trials_[k];
        const Vec2 relative_displacement = s.rows.relative_displacement(d);
        trial.opening = s.normal.at(relative_displacement);
        trial.shearing = s.shear.at(relative_displacement);
        const Vec2 balanced = s.rows.relative_displacement(target);
        trial.linear = linear_forces(k, s.normal.at(balanced), s.shear.at(balanced));
        const CornerEdgeGeometry geometry =
            corner_edge_geometry(moved(contact.corner), moved(contact.edge),
                                 moved(topology.next[static_cast<std::size_t>(contact.edge)]));
        trial.gap_offset = geometry.gap - contact.dilation - trial.opening;
    });
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        const BoltSpring& bolt = p_.bolts[k];
        elongation_[k] = bolt.rows.measure(bolt.elongation, d);
        linear_bolt_[k] = linear_bolt_force(k, bolt.rows.measure(bolt.elongation, target));
    }
}

void TrialContacts::select_first_entrances() {
    first_entrance_.assign(groups_, trials_.size());
    for (std::size_t k = 0; k < trials_.size(); ++k) {
        const int group = p_.contacts[k].group;
        if (group < 0 || p_.contacts[k].inhibited) continue;
        const auto g = static_cast<std::size_t>(group);
        std::size_t& best = first_entrance_[g];
        const auto entrance_depth = [&](std::size_t line) {
            return gap(line) + 2 * p_.contacts[line].inherited_penetration;
        };
        if (best == trials_.size() || entrance_depth(k) > entrance_depth(best)) best = k;
    }
    for_contacts([&](std::size_t k) {
        const int group = p_.contacts[k].group;
        if (group >= 0 && !p_.contacts[k].inhibited)
            trials_[k].may_close =
                p_.contacts[first_entrance_[static_cast<std::size_t>(group)]].line == p_.contacts[k].line;
    });
}

TrialContacts::ForceChange TrialContacts::force_change() {
    struct Largest {
        ForceChange change;
        double force = 0;  ///< of a law
    };
    const auto chunk_value = [&](std::size_t begin, std::size_t end) {
        Largest found;
        for (std::size_t k = begin; k < end; ++k) {
            const Forces law = current_forces(k);
            const Forces& linear = trials_[k].linear;
            const double moved =
                std::max(std::abs(law.normal - linear.normal), std::abs(law.shear - linear.shear));
            found.force = std::max({found.force, std::abs(law.normal), std::abs(law.shear)});
            if (moved > found.change.largest) found.change = {moved, static_cast<int>(k)};
        }
        return found;
    };
    const auto larger = [](const Largest& a, const Largest& b) {
        return Largest{b.change.largest > a.change.largest ? b.change : a.change, std::max(a.force, b.force)};
    };
    const Largest largest = pool_.parallel_reduce(count(), Largest(), chunk_value, larger);
    largest_force_ = largest.force;
    ForceChange change = largest.change;
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        change.largest = std::max(change.largest, std::abs(bolt_force(k) - linear_bolt_[k]));
    }
    return change;
}

double TrialContacts::tolerance() const {
    return std::max(p_.control.force_tolerance * largest_force_, p_.rounding_force);
}

void TrialContacts::update_bounds() {
    compute_bounds(law_reuse_tolerance * tolerance());
}

void TrialContacts::update_all_bounds() {
    compute_bounds(0);
}

ContactLoading TrialContacts::current_loading(std::size_t k) const {
    return {current_forces(k).normal, trials_[k].shearing};
}

void TrialContacts::compute_bounds(double change_tolerance) {
    for_contacts([&](std::size_t k) {
        if (is_on_segment(k)) return;
        const ContactLoading here = current_loading(k);
        const bool open = !trials_[k].may_close || (here.normal <= 0 && !is_bonded(k));
        trials_[k].bounds = open ? Strength{} : bounds_of_single_contact(k, here);
    });
    segment_friction_.update(
        change_tolerance, [this](std::size_t k) { return current_loading(k); },
        [this](std::size_t k, const Strength& bounds) { trials_[k].bounds = bounds; });
}

ContactMotion TrialContacts::motion(std::size_t k) const {
    const Forces forces = current_forces(k);
    const double elastic = elastic_shear(k, trials_[k].shearing);
    return contact_motion(p_.model, p_.contacts[k], p_.springs[k].shear_stiffness, forces.normal,
                          trials_[k].shearing, slip(k, elastic, forces.shear));
}

/// Faces dilate as a whole, from the motion of both of their ends.
template <class Take>
void TrialContacts::dilation_by_law(const Take& take) const {
    if (!dilates_) return;
    for (std::size_t f = 0; f < p_.segments.count(); ++f) {
        const std::span<const int> members = p_.segments.contacts_of(f);
        const JointLaw& law = law_of(static_cast<std::size_t>(members[0]));
        if (!dilates(law)) continue;
        const auto combined =
            segment_motion(members, p_.contacts, [&](int k) { return motion(static_cast<std::size_t>(k)); });
        const double moved = combined ? dilation(law, advance(law, *combined->history, combined->motion)) : 0;
        for (const int k : members) {
            const auto i = static_cast<std::size_t>(k);
            take(i, combined ? moved - p_.contacts[i].dilation : 0);
        }
    }
}

void TrialContacts::update_dilation() {
    dilation_by_law([&](std::size_t k, double by_law) {
        if (!trials_[k].postponed) trials_[k].dilation_increment = by_law;
    });
}

bool TrialContacts::dilation_exceeds_tolerance() const {
    double largest = 0;
    dilation_by_law([&](std::size_t k, double by_law) {
        if (trials_[k].postponed) return;
        const double off = std::abs(by_law - trials_[k].dilation_increment);
        largest = std::max(largest, p_.springs[k].normal_stiffness * off);
    });
    return largest > dilation_tolerance * tolerance();
}

bool TrialContacts::postpone_dilation() {
    bool any = false;
    dilation_by_law([&](std::size_t k, double by_law) {
        Trial& trial = trials_[k];
        if (trial.postponed || std::abs(by_law - trial.dilation_increment) <= std::abs(by_law)) return;
        trial.dilation_increment = 0;
        trial.postponed = true;
        any = true;
    });
    return any;
}

Eigen::VectorXd TrialContacts::shear_bounds() const {
    Eigen::VectorXd shear_bounds(static_cast<Eigen::Index>(2 * trials_.size()));
    Eigen::Index row = 0;
    for (const Trial& trial : trials_) {
        shear_bounds[row++] = trial.bounds.forward;
        shear_bounds[row++] = trial.bounds.backward;
    }
    return shear_bounds;
}

void TrialContacts::set_shear_bounds(const Eigen::VectorXd& shear_bounds) {
    Eigen::Index row = 0;
    for (Trial& trial : trials_) {
        trial.bounds.forward = std::max(shear_bounds[row++], 0.0);
        trial.bounds.backward = std::max(shear_bounds[row++], 0.0);
    }
}

bool TrialContacts::break_bonds() {
    return for_any_contact([&](std::size_t k) {
        const bool breaks = is_bonded(k) && current_forces(k).normal < -trials_[k].bounds.tensile;
        trials_[k].bond_broken = trials_[k].bond_broken || breaks;
        return breaks;
    });
}

bool TrialContacts::violates_rigid_contact(std::size_t k, double tolerance) const {
    const Trial& trial = trials_[k];
    const Forces forces = current_forces(k);
    if (forces.normal > 0 && std::abs(gap(k)) > tolerance) return true;
    if (trial.locked) return std::abs(trial.shearing) > tolerance;
    return forces.shear != 0 && std::copysign(1.0, forces.shear) * trial.shearing < -tolerance;
}

bool TrialContacts::augment(AndersonMixing& mixing) {
    const double tolerance = p_.model.penetration_tolerance;
    std::vector<std::size_t> augmented;
    bool any = false;
    for (std::size_t k = 0; k < trials_.size(); ++k) {
        if (!p_.model.is_augmented(p_.contacts[k].joint_material)) continue;
        augmented.push_back(k);
        any = any || violates_rigid_contact(k, tolerance);
    }
    if (!any) return false;
    Eigen::VectorXd shift(2 * static_cast<Eigen::Index>(augmented.size()));
    Eigen::VectorXd force(shift.size());
    Eigen::Index row = 0;
    for (const std::size_t k : augmented) {
        const Forces forces = current_forces(k);
        shift[row] = trials_[k].stress_free_gap * p_.springs[k].normal_stiffness;
        force[row++] = forces.normal;
        shift[row] = trials_[k].shear_origin;
        force[row++] = forces.shear;
    }
    const Eigen::VectorXd next = mixing.next(shift, force);
    row = 0;
    for (const std::size_t k : augmented) {
        trials_[k].stress_free_gap = std::max(next[row++], 0.0) / p_.springs[k].normal_stiffness;
        trials_[k].shear_origin = next[row++];
    }
    return true;
}

bool TrialContacts::update_active_set() {
    bool changed = for_any_contact([&](std::size_t k) { return update_active_set_of(k); });
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        const double elastic = p_.bolt_force[k] + p_.bolts[k].stiffness * elongation_[k];
        const double law = bolt_force(k);
        const int yielding = elastic == law ? 0 : (elastic > law ? 1 : -1);
        changed = changed || yielding != yielding_[k];
        yielding_[k] = yielding;
    }
    return changed;
}

bool TrialContacts::update_active_set_of(std::size_t k) {
    Trial& trial = trials_[k];
    const Forces law = current_forces(k);
    const double elastic = elastic_shear(k, trial.shearing);
    const bool active = trial.may_close && (law.normal > 0 || is_bonded(k));
    const bool locked = trial.may_close && is_within(elastic, trial.bounds);
    bool changed = active != trial.active || locked != trial.locked;
    if (active && std::abs(law.normal - trial.linear.normal) > tolerance()) {
        const Tangent tangent = tangent_at(k, law.normal);
        changed = changed || tangent.stiffness != trial.tangent.stiffness;
        trial.tangent = tangent;
    }
    trial.active = active;
    trial.locked = locked;
    trial.friction_force = law.shear;
    trial.forward = elastic >= 0;
    return changed;
}

double TrialContacts::slip(std::size_t k, double elastic, double force) const {
    if (!p_.model.is_augmented(p_.contacts[k].joint_material))
        return (elastic - force) / p_.springs[k].shear_stiffness;
    if (elastic == force) return 0;
    return force >= 0 ? std::max(trials_[k].shearing, 0.0) : std::min(trials_[k].shearing, 0.0);
}

void TrialContacts::evaluate(std::span<EvaluatedContact> evaluated_contacts) const {
    for_contacts([&](std::size_t k) { evaluated_contacts[k] = evaluated(k); });
}

EvaluatedContact TrialContacts::evaluated(std::size_t k) const {
    const Trial& trial = trials_[k];
    const Forces forces = current_forces(k);
    EvaluatedContact evaluated;
    evaluated.gap = gap(k);
    evaluated.stress_free_gap = forces.normal > 0 ? trial.stress_free_gap : 0;
    evaluated.normal_force = forces.normal;
    evaluated.shear_force = forces.shear;
    evaluated.displacement = trial.shearing;
    evaluated.dilation_increment = trial.dilation_increment;
    evaluated.bond_broken = trial.bond_broken;
    if (forces.normal > 0 || (is_bonded(k) && trial.may_close)) {
        const double elastic = elastic_shear(k, trial.shearing);
        evaluated.state = is_within(elastic, trial.bounds) ? ContactState::locked : ContactState::sliding;
        evaluated.slip = slip(k, elastic, forces.shear);
    }
    return evaluated;
}

}  // namespace rockslope::dda
