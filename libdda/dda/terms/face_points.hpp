#pragma once

#include <array>

#include "dda/block/mid_step.hpp"
#include "dda/model/face.hpp"

namespace rockslope::dda {

/// A point on a face at which an integral along it is evaluated.
struct FacePoint {
    int block = 0;
    double fraction = 0;          ///< of the way along the face's part, in (0, 1)
    double weight = 0;            ///< m, the length that the point stands for
    Vec2 arm = Vec2::Zero();      ///< m, from the block's centroid
    Vec2 tangent = Vec2::Zero();  ///< along the edge
    Vec2 normal = Vec2::Zero();   ///< out of the rock
};

/// Gauss's two points of a part of an edge, half-way through the step: exact for polynomials up to the third
/// degree, so for the product of a linear traction and the linear displacements of a block.
std::array<FacePoint, 2> face_points(const Model& model, const MidStep& mid, const FacePart& face);

}  // namespace rockslope::dda
