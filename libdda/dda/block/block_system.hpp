#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/base/types.hpp"
#include "dda/geometry/simplex.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The state of all blocks at one instant; small and copied freely.
struct BlockSystem {
    std::vector<Vec2> vertices;        ///< per corner, m
    std::vector<Vec2> points;          ///< per material point of the model, m
    std::vector<AreaMoments> moments;  ///< per block, of the present shape; holds the centroid
    std::vector<double> mass;          ///< per block, kg per metre; constant
    std::vector<double> rotation;      ///< per block, accumulated, rad
    std::vector<Vec3> stress;          ///< per block (sigma_x, sigma_y, tau_xy), Pa, tension positive
    std::vector<Vec6> velocity;        ///< per block, rates of the six unknowns
    std::vector<Vec6> acceleration;    ///< per block

    const Vec2& centroid(int block) const { return moments[static_cast<std::size_t>(block)].centroid; }
};

/// The state before the first step: the model's geometry, initial stress and initial velocity.
BlockSystem initial_block_system(const Model& model);

/// A block's map over one step: x -> centroid + (u0, v0) + R(r0) exp(strain) (x - centroid). The rotation is
/// exact, so that a spinning block neither grows nor shears, and strains that cancel leave no change of area
/// (theory, Eq. (9)).
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

/// direction^T T(arm): what a displacement along `direction` at a point is in the block's unknowns.
inline Vec6 project(const Vec2& direction, const Vec2& arm) {
    return {direction.x(),           direction.y(),
            cross(arm, direction),   direction.x() * arm.x(),
            direction.y() * arm.y(), (direction.x() * arm.y() + direction.y() * arm.x()) / 2};
}

/// A symmetric plane tensor (xx, yy, xy) turned by an angle, rad. With `engineering` the third component is
/// twice the tensor's.
Vec3 rotate_tensor(const Vec3& tensor, double angle, bool engineering);

/// Moves every block by its displacement: vertices, material points, moments, accumulated rotation; stresses
/// gain elasticity * strain and turn with the block; rates of strain turn as well. Velocities must already be
/// those of the step's end.
/// @param displacement per block.
void move_blocks(const Model& model, std::span<const Vec6> displacement, const ThreadPool& pool,
                 BlockSystem& blocks);

}  // namespace rockslope::dda
