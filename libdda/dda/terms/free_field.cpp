#include "dda/terms/free_field.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

double within_table(const TimeTable& table, double time) {
    if (table.empty() || time < table.times().front() || time > table.times().back()) return 0;
    return table.at(time);
}

/// A column in one direction: a chain of masses and springs, per metre of width.
struct Chain {
    std::vector<double> mass;       ///< kg/m2, per layer
    std::vector<double> stiffness;  ///< Pa/m, per layer
    std::vector<double> retarded;   ///< 1 + retardation time over the step, per layer
    double impedance = 0;           ///< Pa s/m, at the base
};

/// @param axis 0: shear waves; 1: pressure waves.
Chain chain_of(const Model& model, const FreeField& field, const BlockSystem& blocks, int axis, double dt) {
    const int modulus = axis == 0 ? 2 : 0;
    Chain chain;
    for (std::size_t k = 0; k < field.layers(); ++k) {
        const BlockMaterial& rock = model.material_of(field.rock[k]);
        const double height = field.nodes[k + 1] - field.nodes[k];
        const double stiff = elasticity(rock, model.plane)(modulus, modulus);
        chain.mass.push_back(rock.density * height);
        chain.stiffness.push_back(stiff / height);
        chain.retarded.push_back(1 + retardation_time(rock, blocks.moments[field.rock[k]]) / dt);
        if (k == 0) chain.impedance = std::sqrt(rock.density * stiff);
    }
    return chain;
}

/// A symmetric tridiagonal system of equations.
struct Tridiagonal {
    std::vector<double> diagonal, above, right;

    explicit Tridiagonal(std::size_t size) : diagonal(size, 0.0), above(size, 0.0), right(size, 0.0) {}
    /// Solves by Gaussian elimination (Thomas algorithm); overwrites the system.
    std::vector<double> solution() {
        const std::size_t size = diagonal.size();
        for (std::size_t k = 1; k < size; ++k) {
            const double factor = above[k - 1] / diagonal[k - 1];
            diagonal[k] -= factor * above[k - 1];
            right[k] -= factor * right[k - 1];
        }
        right[size - 1] /= diagonal[size - 1];
        for (std::size_t k = size - 1; k-- > 0;)
            right[k] = (right[k] - above[k] * right[k + 1]) / diagonal[k];
        return right;
    }
};

/// The displacements of a step in one direction, Eq. (51) with the ends of Eq. (52). @param push Pa, of the
/// incident wave at the foot.
std::vector<double> chain_step(const Chain& chain, const ColumnMotion& motion, int axis, double push,
                               double mass_damping, const Newmark& newmark) {
    const double rate = newmark.velocity_rate();
    const double inertia = 1 / (newmark.beta * newmark.dt * newmark.dt) + mass_damping * rate;
    Tridiagonal system(motion.displacement.size());
    // Velocity, and inertia force per unit mass, of a node at the end of the step for zero displacement.
    const auto velocity = [&](std::size_t k) {
        return newmark.velocity_at_zero_displacement(motion.velocity[k][axis], motion.acceleration[k][axis]);
    };
    const auto force = [&](std::size_t k) {
        return newmark.acceleration(0.0, motion.velocity[k][axis], motion.acceleration[k][axis]) +
               mass_damping * velocity(k);
    };
    for (std::size_t k = 0; k < chain.mass.size(); ++k) {
        const double stiff = chain.stiffness[k] * chain.retarded[k], sixth = chain.mass[k] / 6;
        const double stretch = motion.displacement[k + 1][axis] - motion.displacement[k][axis];
        for (const std::size_t i : {k, k + 1}) {
            const std::size_t other = 2 * k + 1 - i;
            system.diagonal[i] += 2 * sixth * inertia + stiff;
            system.right[i] -= sixth * (2 * force(i) + force(other));
            system.right[i] += (i == k ? 1 : -1) * chain.stiffness[k] * stretch;
        }
        system.above[k] = sixth * inertia - stiff;
    }
    system.diagonal[0] += chain.impedance * rate;
    system.right[0] += push - chain.impedance * velocity(0);
    return system.solution();
}

ColumnMotion advance_column(const Model& model, const StageInstant& end, const BlockSystem& blocks,
                            const FreeField& field, const ColumnMotion& before, const Newmark& newmark) {
    const Stage& stage = end.stage;
    const IncidentMotion wave = incident_motion(end, field.base_boundary);
    ColumnMotion after = before;
    for (const int axis : {0, 1}) {
        const Chain chain = chain_of(model, field, blocks, axis, newmark.dt);
        const double push = 2 * (chain.impedance * wave.velocity[axis] + wave.traction[axis]);
        const std::vector<double> moved = chain_step(chain, before, axis, push, stage.mass_damping, newmark);
        for (std::size_t k = 0; k < moved.size(); ++k) {
            const double v0 = before.velocity[k][axis], a0 = before.acceleration[k][axis];
            const double a1 = newmark.acceleration(moved[k], v0, a0);
            after.displacement[k][axis] += moved[k];
            after.velocity[k][axis] = stage.dynamic_coefficient * newmark.velocity(v0, a0, a1);
            after.acceleration[k][axis] = a1;
        }
    }
    return after;
}

}  // namespace

FreeFieldMotions fields_at_rest(const Model& model) {
    FreeFieldMotions motions;
    for (const ViscousBoundary& boundary : model.viscous_boundaries) {
        const std::size_t count = boundary.free_field ? boundary.free_field->nodes.size() : 0;
        const std::vector<Vec2> zero(count, Vec2::Zero());
        motions.push_back({zero, zero, zero});
    }
    return motions;
}

FreeFieldMotions advance_fields(const Model& model, const StageInstant& end, const BlockSystem& blocks,
                                const FreeFieldMotions& before, const Newmark& newmark) {
    FreeFieldMotions after = fields_at_rest(model);
    if (end.stage.is_static()) return after;
    for (std::size_t k = 0; k < model.viscous_boundaries.size(); ++k) {
        const auto& field = model.viscous_boundaries[k].free_field;
        if (field) after[k] = advance_column(model, end, blocks, *field, before[k], newmark);
    }
    return after;
}

FieldPoint field_at(const Model& model, const FreeField& field, const ColumnMotion& motion, double height) {
    const auto above = std::upper_bound(field.nodes.begin() + 1, field.nodes.end() - 1, height);
    const std::size_t k = above - field.nodes.begin() - 1;
    const double thickness = field.nodes[k + 1] - field.nodes[k];
    const double fraction = std::clamp((height - field.nodes[k]) / thickness, 0.0, 1.0);
    const Vec2 strain = (motion.displacement[k + 1] - motion.displacement[k]) / thickness;
    const Mat3 modulus = elasticity(model.material_of(field.rock[k]), model.plane);
    // The velocity and the stresses of Eq. (53).
    return {(1 - fraction) * motion.velocity[k] + fraction * motion.velocity[k + 1],
            {modulus(0, 1) * strain.y(), modulus(2, 2) * strain.x()}};
}

IncidentMotion incident_motion(const StageInstant& instant, const std::string& boundary) {
    IncidentMotion sum;
    for (const IncidentWave& wave : instant.stage.incident_waves) {
        if (!wave.boundary.empty() && wave.boundary != boundary) continue;
        (wave.x_is_traction ? sum.traction : sum.velocity).x() += within_table(wave.x, instant.time);
        (wave.y_is_traction ? sum.traction : sum.velocity).y() += within_table(wave.y, instant.time);
    }
    return sum;
}

}  // namespace rockslope::dda
