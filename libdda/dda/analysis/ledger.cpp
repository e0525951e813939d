#include "dda/analysis/ledger.hpp"

#include <Eigen/LU>

#include "dda/contact/contact_stiffness.hpp"

namespace rockslope::dda {

namespace {

double kinetic_energy(const RowMap& rows, const BlockSystem& blocks) {
    double sum = 0;
    for (const int block : rows.block_of) {
        const auto b = static_cast<std::size_t>(block);
        const Vec6& v = blocks.velocity[b];
        sum += v.dot(mass_matrix(blocks.mass[b], blocks.moments[b]) * v) / 2;
    }
    return sum;
}

double strain_energy(const Model& model, const RowMap& rows, const BlockSystem& blocks) {
    double sum = 0;
    for (const int block : rows.block_of) {
        const auto b = static_cast<std::size_t>(block);
        const Vec3& stress = blocks.stress[b];
        if (stress.isZero(0)) continue;
        const Vec3 strain = elasticity(model.material_of(block), model.plane).inverse() * stress;
        sum += blocks.moments[b].area * stress.dot(strain) / 2;
    }
    return sum;
}

double spring_energy(double force, double stiffness) {
    return force * force / (2 * stiffness);
}

/// An augmented contact does not give way, so it stores nothing.
double contact_energy(const Model& model, const std::vector<Contact>& contacts) {
    double sum = 0;
    for (const Contact& contact : contacts) {
        if (contact.state == ContactState::open || model.is_augmented(contact.joint_material)) continue;
        sum += normal_spring(model, contact).energy(contact.normal_force) +
               spring_energy(contact.shear_force, shear_stiffness(model, contact));
    }
    return sum;
}

double bolt_stiffness(const Model& model, const BoltSpec& bolt) {
    const Vec2& from = model.material_points[static_cast<std::size_t>(bolt.first)].position;
    const Vec2& to = model.material_points[static_cast<std::size_t>(bolt.second)].position;
    return bolt.axial_stiffness / (to - from).norm();
}

double constraint_energy(const Model& model, const BlockSystem& blocks,
                         const std::vector<double>& bolt_force) {
    double sum = 0;
    for (const FixedPoint& fixed : model.fixed_points) {
        const auto p = static_cast<std::size_t>(fixed.point);
        const Vec2 offset = blocks.points[p] - model.material_points[p].position;
        if (fixed.hold_x) sum += model.fixed_point_penalty * offset.x() * offset.x() / 2;
        if (fixed.hold_y) sum += model.fixed_point_penalty * offset.y() * offset.y() / 2;
    }
    for (std::size_t k = 0; k < model.bolts.size(); ++k) {
        sum += spring_energy(bolt_force[k], bolt_stiffness(model, model.bolts[k]));
    }
    return sum;
}

/// Heights count from the initial configuration, so that the datum costs no digits.
double gravity_energy(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                      const std::vector<Vec2>& datum) {
    double sum = 0;
    for (const int block : rows.block_of) {
        const auto b = static_cast<std::size_t>(block);
        sum -= blocks.mass[b] * model.gravity.dot(blocks.moments[b].centroid - datum[b]);
    }
    return sum;
}

/// Splits what an elastic-plastic spring did in a step: the work of its force at the end of the step, less
/// what it stores more than before and what slipping took, is lost to the end-of-step evaluation. Never
/// negative where the stiffness is constant.
void record_spring(double work, double slip_work, double stored_before, double stored_after, Energy& energy) {
    energy.friction_loss += slip_work;
    energy.numerical_loss += work - slip_work - (stored_after - stored_before);
}

}  // namespace

Ledger::Ledger(const Model& model, const RowMap& rows) : model_(model), rows_(rows) {
    for (const AreaMoments& moments : initial_block_system(model).moments) datum_.push_back(moments.centroid);
}

void Ledger::update_stored_energy(const State& state, Energy& energy) const {
    energy.kinetic = kinetic_energy(rows_, state.blocks);
    energy.strain = strain_energy(model_, rows_, state.blocks);
    energy.contact = contact_energy(model_, state.contacts.contacts);
    energy.constraint = constraint_energy(model_, state.blocks, state.bolt_force);
    energy.gravity = gravity_energy(model_, rows_, state.blocks, datum_);
}

double Ledger::contact_energy_of(const std::vector<Contact>& contacts) const {
    return contact_energy(model_, contacts);
}

void Ledger::record_contacts(const StepWork& step, Energy& energy) const {
    for (std::size_t k = 0; k < step.before.size(); ++k) {
        const Contact& before = step.before[k];
        const EvaluatedContact& after = step.result.contacts[k];
        const ContactSprings& s = step.springs[k];
        const bool stores = !model_.is_augmented(before.joint_material);
        const auto stored_by_normal = [&](double force) { return stores ? s.normal_law.energy(force) : 0; };
        const auto stored_by_shear = [&](double force) {
            return stores ? spring_energy(force, s.shear_stiffness) : 0;
        };
        const bool was_closed = before.state != ContactState::open;
        const bool is_closed = after.state != ContactState::open;
        const double stored_normal = was_closed ? stored_by_normal(before.normal_force) : 0;
        const double stored_shear = was_closed ? stored_by_shear(before.shear_force) : 0;
        if (!is_closed) {
            // An opened contact bears nothing at the step's end: its compression is lost to the integration,
            // the rest snaps free.
            (after.bond_broken ? energy.released : energy.numerical_loss) += stored_normal;
            energy.released += stored_shear;
            continue;
        }
        const double opening = s.rows.measure(s.normal, step.result.displacement);
        // What moves the faces apart against the normal force is taken from the work of shearing.
        record_spring(-after.normal_force * opening, -after.normal_force * after.dilation_increment,
                      stored_normal, stored_by_normal(after.normal_force), energy);
        record_spring(after.shear_force * after.displacement, after.shear_force * after.slip, stored_shear,
                      stored_by_shear(after.shear_force), energy);
        energy.external_work +=
            after.shear_force * s.shear.prescribed - after.normal_force * s.normal.prescribed;
    }
}

void Ledger::record_spring_changes(const StepWork& step, const std::vector<Contact>& after,
                                   Energy& energy) const {
    for (std::size_t k = 0; k < after.size(); ++k) {
        const Contact& contact = after[k];
        if (contact.state == ContactState::open || model_.is_augmented(contact.joint_material)) continue;
        const double stiffness = shear_stiffness(model_, contact);
        if (stiffness == step.springs[k].shear_stiffness) continue;
        energy.released += spring_energy(contact.shear_force, step.springs[k].shear_stiffness) -
                           spring_energy(contact.shear_force, stiffness);
    }
}

void Ledger::record_constraints(const StepWork& step, Energy& energy) const {
    for (std::size_t k = 0; k < step.bolts.size(); ++k) {
        const BoltSpring& bolt = step.bolts[k];
        const double elongation = bolt.rows.measure(bolt.elongation, step.result.displacement);
        const double before = step.bolt_force[k];
        const double after = step.result.bolt_force[k];
        // In this form exactly zero below the yield force, where the other would be the rounding of a tension
        // over a small stiffness.
        const double yielded = (before + bolt.stiffness * elongation - after) / bolt.stiffness;
        record_spring(after * elongation, after * yielded, spring_energy(before, bolt.stiffness),
                      spring_energy(after, bolt.stiffness), energy);
        energy.external_work += after * bolt.elongation.prescribed;
    }
    for (const FixedPoint& fixed : model_.fixed_points) {
        const auto p = static_cast<std::size_t>(fixed.point);
        const int block = model_.material_points[p].block;
        const int row = rows_.row_of[static_cast<std::size_t>(block)];
        if (row < 0) continue;
        const Vec2 moved =
            displacement_matrix(step.mid.points[p] - step.mid.centroid[static_cast<std::size_t>(block)]) *
            step.result.displacement[static_cast<std::size_t>(row)];
        if (fixed.hold_x) energy.numerical_loss += model_.fixed_point_penalty * moved.x() * moved.x() / 2;
        if (fixed.hold_y) energy.numerical_loss += model_.fixed_point_penalty * moved.y() * moved.y() / 2;
    }
}

void Ledger::record_blocks(const StepWork& step, Energy& energy) const {
    const std::vector<Vec6> loads = load_forces(model_, rows_, step.blocks, step.mid, step.loads);
    for (std::size_t row = 0; row < rows_.block_of.size(); ++row) {
        const int block = rows_.block_of[row];
        const auto b = static_cast<std::size_t>(block);
        const Vec6& d = step.result.displacement[row];
        const Vec3 strain = d.tail<3>();
        const double elastic_work = step.blocks.moments[b].area *
                                    strain.dot(elasticity(model_.material_of(block), model_.plane) * strain);
        energy.numerical_loss += elastic_work / 2;
        energy.damping_loss += elastic_work *
                               retardation_time(model_.material_of(block), step.blocks.moments[b]) /
                               step.newmark.dt;
        energy.external_work += loads[row].dot(d);

        const Mat6 mass = mass_matrix(step.blocks.mass[b], step.blocks.moments[b]);
        const Vec6& v0 = step.blocks.velocity[b];
        const Vec6& a0 = step.blocks.acceleration[b];
        const Vec6 a1 = step.newmark.acceleration(d, v0, a0);
        const Vec6 v1 = step.newmark.velocity(v0, a0, a1);
        energy.numerical_loss += d.dot(mass * a1) - (v1.dot(mass * v1) - v0.dot(mass * v0)) / 2;
        energy.damping_loss += step.mass_damping * v1.dot(mass * d);
        const double kept = step.velocity_factor;
        energy.damping_loss += (1 - kept * kept) * v1.dot(mass * v1) / 2;
    }
}

/// What holds a face in a static stage is outside: its reaction does external work.
void Ledger::record_boundaries(const StepWork& step, Energy& energy) const {
    for (const BoundaryTerm& term : step.boundaries) {
        const auto row = static_cast<std::size_t>(term.row);
        const auto b = static_cast<std::size_t>(rows_.block_of[row]);
        const Vec6& d = step.result.displacement[row];
        const Vec6 v1 =
            step.newmark.velocity_rate() * d +
            step.newmark.velocity_at_zero_displacement(step.blocks.velocity[b], step.blocks.acceleration[b]);
        energy.boundary_loss += d.dot(term.damping * v1);
        energy.external_work += d.dot(term.force - term.stiffness * d);
    }
}

}  // namespace rockslope::dda
