#include "dda/analysis/ledger.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <functional>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/trial/joint_motion.hpp"
#include "dda/trial/shear_energy.hpp"

namespace rockslope::dda {

namespace {

double spring_energy(double force, double stiffness) {
    return force * force / (2 * stiffness);
}

/// Whether a closed contact bears nothing because its dashpot pulls. Its shear spring is released.
template <class AnyContact>
bool is_rebounding(const AnyContact& contact) {
    return contact.normal_force == 0 && contact.shear_force == 0 && contact.normal_spring_force > 0;
}

/// An augmented contact is rigid and stores no energy.
double energy_of(const Model& model, const Contact& contact) {
    if (contact.state == ContactState::open || model.is_augmented(contact.joint_material)) return 0;
    const double shear =
        is_rebounding(contact) ? 0 : shear_energy(model, contact, shear_stiffness(model, contact));
    return normal_spring(model, contact).energy(contact.normal_spring_force) + shear;
}

/// The shear springs of a joint segment. @param stiffness_of the stiffness of a contact's, N/m per metre.
template <class StiffnessOf>
SharedSpring shared_spring(const Model& model, std::span<const ContactIndex> members,
                           ContactSpan<const Contact> contacts, const StiffnessOf& stiffness_of) {
    SharedSpring spring;
    if (model.is_augmented(contacts[members[0]].joint_material)) return spring;
    for (const ContactIndex k : members) {
        const Contact& contact = contacts[k];
        if (contact.state == ContactState::open || is_rebounding(contact))
            spring.add_open(stiffness_of(k));
        else
            spring.add(sheared(contact).spring_force(
                           locked_dilation(model, contact.joint_material, contact.history)),
                       stiffness_of(k));
    }
    return spring;
}

double bolt_stiffness(const Model& model, const BoltSpec& bolt) {
    const Vec2& from = model.material_points[bolt.first].position;
    const Vec2& to = model.material_points[bolt.second].position;
    return bolt.axial_stiffness / (to - from).norm();
}

double constraint_energy(const Model& model, const BlockSystem& blocks,
                         const std::vector<double>& bolt_force) {
    double sum = 0;
    for (const FixedPoint& fixed : model.fixed_points) {
        const Vec2 offset = blocks.points[fixed.point] - model.material_points[fixed.point].position;
        if (fixed.hold_x) sum += model.fixed_point_penalty * offset.x() * offset.x() / 2;
        if (fixed.hold_y) sum += model.fixed_point_penalty * offset.y() * offset.y() / 2;
    }
    for (std::size_t k = 0; k < model.bolts.size(); ++k) {
        sum += spring_energy(bolt_force[k], bolt_stiffness(model, model.bolts[k]));
    }
    return sum;
}

/// Splits the work that the force at the end of the step does on an elastic-plastic spring. The slip's part
/// is friction loss, the change of the stored energy stays, and the remainder is the loss of the end-of-step
/// evaluation, Eq. (42). That loss is never negative where the stiffness is constant.
void record_spring(double work, double slip_work, double stored_before, double stored_after, Energy& energy) {
    energy.friction_loss += slip_work;
    energy.numerical_loss += work - slip_work - (stored_after - stored_before);
}

}  // namespace

Ledger::Ledger(const Model& model, const RowMap& rows, const ThreadPool& pool)
    : model_(model), rows_(rows), pool_(pool) {
    for (const AreaMoments& moments : initial_block_system(model).moments) datum_.push_back(moments.centroid);
}

template <class Index, class Losses>
void Ledger::add_losses(std::size_t count, const Losses& losses, Energy& energy) const {
    const auto of_chunk = [&](std::size_t begin, std::size_t end) {
        Energy part;
        for (const Index k : indices<Index>(begin, end)) losses(k, part);
        return part;
    };
    const auto add = [](Energy all, const Energy& part) {
        all.add_losses(part);
        return all;
    };
    energy.add_losses(pool_.parallel_reduce(count, Energy(), of_chunk, add));
}

template <class Index, class EnergyOf>
double Ledger::sum(std::size_t count, const EnergyOf& energy_of) const {
    const auto of_chunk = [&](std::size_t begin, std::size_t end) {
        double part = 0;
        for (const Index k : indices<Index>(begin, end)) part += energy_of(k);
        return part;
    };
    return pool_.parallel_reduce(count, 0.0, of_chunk, std::plus<>());
}

double Ledger::contact_energy(ContactSpan<const Contact> contacts, const JointSegments& segments) const {
    double energy =
        sum<ContactIndex>(contacts.size(), [&](ContactIndex k) { return energy_of(model_, contacts[k]); });
    const auto stiffness_of = [&](ContactIndex k) { return shear_stiffness(model_, contacts[k]); };
    for (std::size_t segment = 0; segment < segments.count(); ++segment)
        energy -= shared_spring(model_, segments.contacts_of(segment), contacts, stiffness_of).uneven();
    return energy;
}

double Ledger::kinetic_energy(const BlockSystem& blocks) const {
    return sum<RowIndex>(rows_.count(), [&](RowIndex row) {
        const BlockIndex b = rows_.block_of[row];
        const Vec6& v = blocks.velocity[b];
        return v.dot(mass_matrix(blocks.mass[b], blocks.moments[b]) * v) / 2;
    });
}

double Ledger::strain_energy(const BlockSystem& blocks) const {
    return sum<RowIndex>(rows_.count(), [&](RowIndex row) {
        const BlockIndex b = rows_.block_of[row];
        const Vec3& stress = blocks.stress[b];
        if (stress.isZero(0)) return 0.0;
        const Vec3 strain = elasticity(model_.material_of(b), model_.plane).inverse() * stress;
        return blocks.moments[b].area * stress.dot(strain) / 2;
    });
}

double Ledger::gravity_energy(const BlockSystem& blocks) const {
    return sum<RowIndex>(rows_.count(), [&](RowIndex row) {
        const BlockIndex b = rows_.block_of[row];
        return -blocks.mass[b] * model_.gravity.dot(blocks.moments[b].centroid - datum_[b]);
    });
}

void Ledger::record_step(const StepWork& step, ContactSpan<const Contact> last, State& after) const {
    record_transfer(last, step.before, step.segments, after.time, after.energy);
    record_contacts(step, after.contacts.contacts, after.energy);
    record_spring_changes(step, after.contacts.contacts, after.energy);
    record_constraints(step, after.energy);
    record_blocks(step, after.energy);
    record_boundaries(step, after.energy);
    update_stored_energy(after, step.segments, after.energy);
}

void Ledger::update_stored_energy(const State& state, Energy& energy) const {
    update_stored_energy(state, JointSegments(model_, state.contacts.contacts), energy);
}

void Ledger::update_stored_energy(const State& state, const JointSegments& segments, Energy& energy) const {
    energy.kinetic = kinetic_energy(state.blocks);
    energy.strain = strain_energy(state.blocks);
    energy.contact = contact_energy(state.contacts.contacts, segments);
    energy.constraint = constraint_energy(model_, state.blocks, state.bolt_force);
    energy.gravity = gravity_energy(state.blocks);
}

void Ledger::record_transfer(ContactSpan<const Contact> before, ContactSpan<const Contact> after,
                             const JointSegments& segments, double time, Energy& energy) const {
    const double lost = energy.contact - contact_energy(after, segments);
    energy.released += lost;
    if (!(-lost > energy.largest_spring_gain.amount)) return;
    auto old = before.begin();
    for (const Contact& contact : after) {
        while (old != before.end() && comes_before(*old, contact)) ++old;
        const bool continues = old != before.end() && !comes_before(contact, *old);
        const double gain = energy_of(model_, contact) - (continues ? energy_of(model_, *old) : 0);
        if (gain > energy.largest_spring_gain.amount)
            energy.largest_spring_gain = {gain, time, contact.corner_block, contact.edge_block,
                                          contact.joint_material};
    }
}

void Ledger::record_contacts(const StepWork& step, const PerContact<Contact>& advanced,
                             Energy& energy) const {
    const auto record_friction = [&](ContactIndex k, double loss, Energy& to) {
        const Contact& contact = step.before[k];
        to.friction_loss += loss;
        to.friction_returned += std::max(-loss, 0.0);
        to.largest_gain.keep_larger(
            {-loss, step.time, contact.corner_block, contact.edge_block, contact.joint_material});
    };
    const auto slips = [&](ContactIndex k) { return step.result.contacts[k].slip != 0; };
    const auto record_single = [&](ContactIndex k, Energy& to) {
        if (has_segment_history(model_.joint_material_at(step.before[k].joint_material).law)) return;
        record_friction(k, record_contact(step, k, advanced[k], slips(k), to), to);
    };
    add_losses<ContactIndex>(step.before.size(), record_single, energy);
    // A joint segment slips and dilates as a whole, and its contacts pass energy to each other.
    const auto stiffness_of = [&](ContactIndex k) { return step.springs[k].shear_stiffness; };
    for (std::size_t segment = 0; segment < step.segments.count(); ++segment) {
        const auto members = step.segments.contacts_of(segment);
        const bool any_slips = std::any_of(members.begin(), members.end(), slips);
        double loss = 0;
        for (const ContactIndex k : members) loss += record_contact(step, k, advanced[k], any_slips, energy);
        const double less_uneven = shared_spring(model_, members, advanced, stiffness_of).uneven() -
                                   shared_spring(model_, members, step.before, stiffness_of).uneven();
        (any_slips ? loss : energy.released) += less_uneven;
        record_friction(members[0], loss, energy);
    }
}

/// Whether the dilation of a contact's joint is part of what its shearing stores.
bool Ledger::stores_dilation(const EvaluatedContact& after, const Contact& contact) const {
    return after.state != ContactState::open && !is_rebounding(after) &&
           !model_.is_augmented(contact.joint_material) &&
           dilates(model_.joint_material_at(contact.joint_material).law);
}

double Ledger::record_contact(const StepWork& step, ContactIndex k, const Contact& advanced, bool slips,
                              Energy& energy) const {
    const Contact& before = step.before[k];
    const EvaluatedContact& after = step.result.contacts[k];
    const ContactSprings& s = step.springs[k];
    const bool stores = !model_.is_augmented(before.joint_material);
    const auto stored_by_normal = [&](double force) { return stores ? s.normal_law.energy(force) : 0; };
    const bool was_closed = before.state != ContactState::open;
    const bool is_closed = after.state != ContactState::open;
    const double stored_normal = was_closed ? stored_by_normal(before.normal_spring_force) : 0;
    const double stored_shear = was_closed && stores ? shear_energy(model_, before, s.shear_stiffness) : 0;
    if (!is_closed) {
        // The normal force of an opened contact is zero at the end of the step. Its normal energy is lost
        // to the integration and its dashpot, or released if a bond broke. Its shear energy is released.
        if (after.bond_broken)
            energy.released += stored_normal;
        else
            record_normal_loss(step, k, stored_normal, energy);
        if (after.shear_force == 0) {
            energy.released += stored_shear;
            return 0;
        }
        // Its cohesion acted to the end of the step, Eq. (75), and its shear spring is released there.
        const double stored_at_end = stores ? spring_energy(after.shear_force, s.shear_stiffness) : 0;
        energy.released += stored_at_end;
        energy.external_work += after.shear_force * s.shear.prescribed;
        return after.shear_force * after.displacement - (stored_at_end - stored_shear);
    }
    const double opening = s.rows.measure(s.normal, step.result.displacement);
    const double shear_work = after.shear_force * after.displacement;
    const double dilation_work = -after.normal_force * after.dilation_increment;
    const double normal_loss = -after.normal_force * opening - dilation_work -
                               (stored_by_normal(after.normal_spring_force) - stored_normal);
    record_normal_loss(step, k, normal_loss, energy);
    if (is_rebounding(after)) {
        energy.released += stored_shear;
        return 0;
    }
    energy.external_work += after.shear_force * s.shear.prescribed - after.normal_force * s.normal.prescribed;
    if (stores_dilation(after, before))
        return record_dilating_shear(step, k, advanced, {shear_work + dilation_work, stored_shear, slips},
                                     energy);
    const double stored = stores ? spring_energy(after.shear_force, s.shear_stiffness) : 0;
    const double slip_work = after.shear_force * after.slip;
    energy.numerical_loss += shear_work - slip_work - (stored - stored_shear);
    return slip_work + dilation_work;
}

/// Divides what a contact loses in its normal motion between its dashpot and the integration, Eq. (88).
void Ledger::record_normal_loss(const StepWork& step, ContactIndex k, double loss, Energy& energy) const {
    const double share = step.dashpots.empty() ? 0 : step.dashpots[k].share_of_loss;
    if (share == 0) {
        energy.numerical_loss += loss;
        return;
    }
    const auto closure = [&](double spring_force) {
        return std::max(step.springs[k].normal_law.closure(spring_force), 0.0);
    };
    // Inertia gains this part of the excess of Eq. (42) where gamma is below 1.
    const double closed =
        closure(step.result.contacts[k].normal_spring_force) - closure(step.before[k].normal_spring_force);
    const double of_inertia =
        std::max(1 - step.newmark.gamma, 0.0) * step.springs[k].normal_stiffness * closed * closed;
    const double of_dashpot = share * std::max(loss - of_inertia, 0.0);
    energy.contact_damping_loss += of_dashpot;
    energy.numerical_loss += loss - of_dashpot;
}

/// Splits the work of shearing and dilating a joint: what neither its spring and its dilation store, Eq.
/// (78), nor the end-of-step evaluation of the spring loses, Eq. (42), is friction loss if the joint segment
/// slips. A locked one releases energy where its spring is found anew; its other difference is that of the
/// evaluation. What the dilation of a joint stored before its first slip is released.
double Ledger::record_dilating_shear(const StepWork& step, ContactIndex k, const Contact& advanced,
                                     const Shearing& shearing, Energy& energy) const {
    const EvaluatedContact& after = step.result.contacts[k];
    const double stiffness = step.springs[k].shear_stiffness;
    const LockedDilation dilating = locked_dilation(model_, advanced.joint_material, advanced.history);
    const bool was_closed = step.before[k].state != ContactState::open;
    const double matched =
        was_closed ? shear_energy_before_slip(model_, step.before[k], dilating, stiffness) : 0;
    energy.released += shearing.stored_before - matched;
    const double elastic = after.displacement - after.slip;
    const double evaluation_loss = stiffness * elastic * elastic / 2;
    const double rest =
        shearing.work - evaluation_loss - (shear_energy(model_, advanced, stiffness) - matched);
    energy.numerical_loss += evaluation_loss;
    if (shearing.segment_slips) return rest;
    if (shear_stiffness(model_, advanced) != stiffness)
        energy.released += rest;
    else
        energy.numerical_loss += rest;
    return 0;
}

void Ledger::record_spring_changes(const StepWork& step, const PerContact<Contact>& after,
                                   Energy& energy) const {
    const auto before_of = [&](ContactIndex k) { return step.springs[k].shear_stiffness; };
    const auto after_of = [&](ContactIndex k) { return shear_stiffness(model_, after[k]); };
    energy.released += sum<ContactIndex>(after.size(), [&](ContactIndex k) {
        const Contact& contact = after[k];
        if (contact.state == ContactState::open || model_.is_augmented(contact.joint_material)) return 0.0;
        if (after_of(k) == before_of(k)) return 0.0;
        return shear_energy(model_, contact, before_of(k)) - shear_energy(model_, contact, after_of(k));
    });
    for (std::size_t segment = 0; segment < step.segments.count(); ++segment) {
        const auto members = step.segments.contacts_of(segment);
        energy.released -= shared_spring(model_, members, after, before_of).uneven() -
                           shared_spring(model_, members, after, after_of).uneven();
    }
}

void Ledger::record_constraints(const StepWork& step, Energy& energy) const {
    for (std::size_t k = 0; k < step.bolts.size(); ++k) {
        const BoltSpring& bolt = step.bolts[k];
        const double elongation = bolt.rows.measure(bolt.elongation, step.result.displacement);
        const double before = step.bolt_force[k];
        const double after = step.result.bolt_force[k];
        // This form is exactly zero below the yield force. elongation - (after - before) / stiffness would
        // leave the rounding of the force divided by a small stiffness.
        const double yielded = (before + bolt.stiffness * elongation - after) / bolt.stiffness;
        record_spring(after * elongation, after * yielded, spring_energy(before, bolt.stiffness),
                      spring_energy(after, bolt.stiffness), energy);
        energy.external_work += after * bolt.elongation.prescribed;
    }
    for (const FixedPoint& fixed : model_.fixed_points) {
        const BlockIndex block = model_.material_points[fixed.point].block;
        const RowIndex row = rows_.row_of[block];
        if (!row.exists()) continue;
        const Vec2 moved = displacement_matrix(step.mid.points[fixed.point] - step.mid.centroid[block]) *
                           step.result.displacement[row];
        if (fixed.hold_x) energy.numerical_loss += model_.fixed_point_penalty * moved.x() * moved.x() / 2;
        if (fixed.hold_y) energy.numerical_loss += model_.fixed_point_penalty * moved.y() * moved.y() / 2;
    }
}

void Ledger::record_blocks(const StepWork& step, Energy& energy) const {
    const PerRow<Vec6> loads = load_forces(model_, rows_, step.blocks, step.mid, step.loads);
    const auto record_block = [&](RowIndex row, Energy& to) {
        const BlockIndex b = rows_.block_of[row];
        const Vec6& d = step.result.displacement[row];
        const Vec3 strain = d.tail<3>();
        const double elastic_work = step.blocks.moments[b].area *
                                    strain.dot(elasticity(model_.material_of(b), model_.plane) * strain);
        to.numerical_loss += elastic_work / 2;
        to.damping_loss +=
            elastic_work * retardation_time(model_.material_of(b), step.blocks.moments[b]) / step.newmark.dt;
        to.external_work += loads[row].dot(d);

        const Mat6 mass = mass_matrix(step.blocks.mass[b], step.blocks.moments[b]);
        const Vec6& v0 = step.blocks.velocity[b];
        const Vec6& a0 = step.blocks.acceleration[b];
        const Vec6 a1 = step.newmark.acceleration(d, v0, a0);
        const Vec6 v1 = step.newmark.velocity(v0, a0, a1);
        to.numerical_loss += d.dot(mass * a1) - (v1.dot(mass * v1) - v0.dot(mass * v0)) / 2;
        to.damping_loss += step.mass_damping * v1.dot(mass * d);
        const double factor = step.velocity_factor;
        to.damping_loss += (1 - factor * factor) * v1.dot(mass * v1) / 2;
    };
    add_losses<RowIndex>(rows_.count(), record_block, energy);
}

/// The springs that hold a boundary face in a static stage are external: their reaction does external work.
void Ledger::record_boundaries(const StepWork& step, Energy& energy) const {
    for (const BoundaryTerm& term : step.boundaries) {
        const BlockIndex b = rows_.block_of[term.row];
        const Vec6& d = step.result.displacement[term.row];
        const Vec6 v1 =
            step.newmark.velocity_rate() * d +
            step.newmark.velocity_at_zero_displacement(step.blocks.velocity[b], step.blocks.acceleration[b]);
        energy.boundary_loss += d.dot(term.damping * v1);
        energy.external_work += d.dot(term.force - term.stiffness * d);
    }
}

}  // namespace rockslope::dda
