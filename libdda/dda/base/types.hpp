#pragma once

#include <Eigen/Core>

namespace rockslope::dda {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
/// The six unknowns of a block, Eq. (1): (u0, v0, r0, eps_x, eps_y, gamma_xy) about its centroid.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The third component of the cross product of two plane vectors.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}
/// The vector rotated by 90 degrees counter-clockwise.
inline Vec2 perpendicular(const Vec2& a) {
    return {-a.y(), a.x()};
}

}  // namespace rockslope::dda
