#pragma once

#include "common/base/thread_pool.hpp"
#include "dda/base/types.hpp"
#include "dda/geometry/simplex.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The state of all blocks at one instant; small and copied freely.
struct BlockSystem {
    PerCorner<Vec2> vertices;       ///< m
    PerPoint<Vec2> points;          ///< material points of the model, m
    PerBlock<AreaMoments> moments;  ///< of the present shape, about its centroid
    PerBlock<double> mass;          ///< kg per metre; constant
    PerBlock<double> rotation;      ///< accumulated, rad
    PerBlock<Vec3> stress;          ///< (sigma_x, sigma_y, tau_xy), Pa, tension positive
    PerBlock<Vec6> velocity;        ///< rates of the six unknowns
    PerBlock<Vec6> acceleration;

    /// The centroid of a block, m.
    const Vec2& centroid(BlockIndex block) const { return moments[block].centroid; }
};

/// The state before the first step: the model's geometry, initial stress and initial velocity.
BlockSystem initial_block_system(const Model& model);

/// The map of a block over one step, x -> centroid + (u0, v0) + R(r0) exp(strain) (x - centroid), Eq. (9).
/// The finite rotation keeps a spinning block from growing or shearing. The exponential makes strains that
/// cancel restore the area.
struct BlockMap {
    Vec2 centroid = Vec2::Zero();
    Vec2 translation = Vec2::Zero();
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Identity();  ///< R(r0) exp(strain)

    BlockMap(const Vec2& centroid, const Vec6& displacement);
    Vec2 operator()(const Vec2& x) const { return centroid + translation + gradient * (x - centroid); }
};

/// T(arm), Eq. (2): the displacement of the point at `arm` from the centroid is T(arm) d.
inline Eigen::Matrix<double, 2, 6> displacement_matrix(const Vec2& arm) {
    Eigen::Matrix<double, 2, 6> t;
    t << 1, 0, -arm.y(), arm.x(), 0, arm.y() / 2,  //
        0, 1, arm.x(), 0, arm.y(), arm.x() / 2;
    return t;
}

/// T(arm) d.
inline Vec2 displacement_at(const Vec2& arm, const Vec6& d) {
    return {d[0] - arm.y() * d[2] + arm.x() * d[3] + arm.y() / 2 * d[5],
            d[1] + arm.x() * d[2] + arm.y() * d[4] + arm.x() / 2 * d[5]};
}

/// direction^T T(arm): row of coefficients that gives a point's displacement along `direction` from d.
inline Vec6 project(const Vec2& direction, const Vec2& arm) {
    return {direction.x(),           direction.y(),
            cross(arm, direction),   direction.x() * arm.x(),
            direction.y() * arm.y(), (direction.x() * arm.y() + direction.y() * arm.x()) / 2};
}

/// The largest displacement of a vertex, m; infinite if a displacement is not finite.
double largest_displacement(const BlockSystem& blocks, const Topology& topology,
                            BlockSpan<const Vec6> displacement, const ThreadPool& pool);

/// A symmetric plane tensor (xx, yy, xy) turned by an angle, rad. With `engineering` the third component is
/// twice the tensor's.
Vec3 rotate_tensor(const Vec3& tensor, double angle, bool engineering);

/// Moves every block by its displacement: vertices, material points, moments and accumulated rotation.
/// Stresses gain elasticity * strain and rotate with the block, Eq. (10); strain rates rotate too. Velocities
/// must already be those of the step's end.
void move_blocks(const Model& model, BlockSpan<const Vec6> displacement, const ThreadPool& pool,
                 BlockSystem& blocks);

}  // namespace rockslope::dda
