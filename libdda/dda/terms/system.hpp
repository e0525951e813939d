#pragma once

#include "dda/block/mid_step.hpp"

namespace rockslope::dda {

/// The numbering of the unknowns: each free block has one row of six unknowns. Fixed and prescribed blocks
/// have none; their displacement is known and is eliminated.
struct RowMap {
    PerBlock<RowIndex> row_of;    ///< per block, -1 when it has no unknowns
    PerRow<BlockIndex> block_of;  ///< per row

    explicit RowMap(const PerBlock<Motion>& motion);
    std::size_t count() const { return block_of.size(); }
    IndexRange<RowIndex> rows() const { return block_of.indices(); }
    /// The displacement of the step per block, prescribed and fixed blocks included, m.
    /// @param prescribed per block, m. @param displacement per row, m.
    PerBlock<Vec6> of_all_blocks(BlockSpan<const Vec6> prescribed, RowSpan<const Vec6> displacement) const {
        PerBlock<Vec6> all(prescribed.begin(), prescribed.end());
        for (const RowIndex row : rows()) all[block_of[row]] = displacement[row];
        return all;
    }
};

/// The terms of the step's equations that do not depend on contacts: diagonal submatrices and load vector.
struct BaseSystem {
    PerRow<Mat6> stiffness;  ///< per row
    PerRow<Vec6> load;       ///< per row
};

/// Newmark's relations for one step, Eqs. (14)-(16): with a displacement d over dt
///   a1 = d / (beta dt^2) - v0 / (beta dt) - (1/2 - beta)/beta a0,
///   v1 = v0 + dt ((1 - gamma) a0 + gamma a1).
/// (beta, gamma) = (1/2, 1) is Shi's integration: a1 constant over the step, v1 = 2 d / dt - v0.
struct Newmark {
    double beta = 0.5;
    double gamma = 1;
    double dt = 0;

    /// The acceleration a1 at the end of the step, Eq. (15).
    template <class Vector>
    Vector acceleration(const Vector& d, const Vector& v0, const Vector& a0) const {
        return (d / dt - v0) / (beta * dt) - (0.5 - beta) / beta * a0;
    }
    /// The derivative of v1 with respect to d, 1/s.
    double velocity_rate() const { return gamma / (beta * dt); }
    /// v1 for d = 0.
    template <class Vector>
    Vector velocity_at_zero_displacement(const Vector& v0, const Vector& a0) const {
        return (1 - gamma / beta) * v0 + dt * ((1 - gamma) - gamma * (0.5 - beta) / beta) * a0;
    }
    /// The velocity v1 at the end of the step, Eq. (16).
    template <class Vector>
    Vector velocity(const Vector& v0, const Vector& a0, const Vector& a1) const {
        return v0 + dt * ((1 - gamma) * a0 + gamma * a1);
    }
};

/// Mass matrix of a block, Eq. (11): integral of rho T^T T over its area, kg per metre (and kg m2 for
/// rotation and strains).
Mat6 mass_matrix(double mass, const AreaMoments& moments);

/// Adds inertia and mass damping. @param mass_damping 1/s
void add_inertia(const RowMap& rows, const BlockSystem& blocks, const Newmark& newmark, double mass_damping,
                 BaseSystem& base);
/// Adds the stiffness of the blocks, their initial stress and their strain damping. @param dt s
void add_elasticity(const Model& model, const RowMap& rows, const BlockSystem& blocks, double dt,
                    BaseSystem& base);
/// Retardation time of a block, s, Eq. (18): viscous stress = time * elasticity * strain rate. It gives the
/// material's damping ratio in the softest strain mode of the block, whose angular frequency is
/// sqrt(E area / (rho I)), with I the larger principal moment of the area.
double retardation_time(const BlockMaterial& material, const AreaMoments& moments);
/// Adds the penalty springs of fixed points, Eq. (39).
void add_fixed_points(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
                      BaseSystem& base);

}  // namespace rockslope::dda
