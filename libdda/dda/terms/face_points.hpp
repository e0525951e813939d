#pragma once

#include <array>

#include "dda/block/mid_step.hpp"
#include "dda/model/face.hpp"

namespace rockslope::dda {

/// An integration point on a face.
struct FacePoint {
    BlockIndex block;
    double fraction = 0;          ///< position along the face part, in (0, 1)
    double weight = 0;            ///< m, integration weight
    Vec2 arm = Vec2::Zero();      ///< m, from the block's centroid
    Vec2 tangent = Vec2::Zero();  ///< unit vector along the edge
    Vec2 normal = Vec2::Zero();   ///< unit vector out of the rock
};

/// The two Gauss points of a part of an edge at mid-step. They integrate polynomials of the third degree
/// exactly, hence also the product of a linear traction and the linear displacement field of a block.
std::array<FacePoint, 2> face_points(const Model& model, const MidStep& mid, const FacePart& face);

}  // namespace rockslope::dda
