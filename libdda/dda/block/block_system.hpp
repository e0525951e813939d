#pragma once

#include <vector>

#include "dda/base/types.hpp"
#include "dda/model/model.hpp"

namespace dda {

/// Second moments of area of a block about its centroid, from simplex integration.
struct Moments {
    double area = 0;      ///< m2
    double xx = 0;        ///< integral of x^2, m4
    double yy = 0;        ///< integral of y^2, m4
    double xy = 0;        ///< integral of x y, m4
};

/// The state of all blocks at one instant; small and copied freely.
struct BlockSystem {
    std::vector<Vec2> vertices;      ///< per corner, m
    std::vector<Vec2> points;        ///< per material point of the model, m
    std::vector<Vec2> centroid;      ///< per block, m
    std::vector<Moments> moments;    ///< per block
    std::vector<double> rotation;    ///< per block, accumulated, rad
    std::vector<Vec3> stress;        ///< per block (sigma_x, sigma_y, tau_xy), Pa, tension positive
    std::vector<Vec6> velocity;      ///< per block, rates of the six unknowns
    std::vector<Vec6> acceleration;  ///< per block
};

/// The state before the first step: the model's geometry, initial stress and initial velocity.
BlockSystem initial_block_system(const Model& model);

/// The displacement of a point that moves with block b, T(point) d, Eq. (2).
Eigen::Matrix<double, 2, 6> displacement_matrix(const Vec2& centroid, const Vec2& point);

}  // namespace dda
