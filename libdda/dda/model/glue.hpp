#pragma once

#include <optional>

#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Whether the unbroken joint never breaks: its law has an unlimited tensile strength.
bool is_glue(const JointMaterial& material);

/// Blocks of more than three corners that are glued to others.
struct GluedPolygons {
    int blocks = 0;                     ///< their number
    BlockIndex first;                   ///< the first of them
    JointMaterialIndex joint_material;  ///< of its first glued face
};

/// The free blocks of more than three corners with a glued face, if there are at least two. Uniform strain
/// makes a mesh of triangles a finite-element mesh, and one of rectangles many times too stiff in bending.
/// Corners at which a face goes on straight do not count.
std::optional<GluedPolygons> glued_polygons(const Model& model);

}  // namespace rockslope::dda
