#include "dda/model/glue.hpp"

#include <cmath>

namespace rockslope::dda {

namespace {

/// Sine of the angle below which a face goes on straight at a corner.
constexpr double straight = 1e-6;

bool turns(const Model& model, CornerIndex corner) {
    const Vec2 arriving = model.vertices[corner] - model.vertices[model.topology.previous[corner]];
    const Vec2 leaving = model.vertices[model.topology.next[corner]] - model.vertices[corner];
    return std::abs(cross(arriving, leaving)) > straight * arriving.norm() * leaving.norm();
}

}  // namespace

bool is_glue(const JointMaterial& material) {
    return std::isinf(strength(material.law, fresh_history(material.law, true), 0, 1).tensile);
}

std::optional<GluedPolygons> glued_polygons(const Model& model) {
    IndexedVector<JointMaterialIndex, char> glue;
    for (const JointMaterial& material : model.joint_materials) glue.push_back(is_glue(material) ? 1 : 0);
    GluedPolygons found;
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free) continue;
        int corners = 0;
        JointMaterialIndex glued = JointMaterialIndex::none();
        for (const CornerIndex corner : model.topology.corners_of(block)) {
            corners += turns(model, corner) ? 1 : 0;
            const JointMaterialIndex material = model.topology.joint_material[edge_from(corner)];
            if (!glued.exists() && material.exists() && glue[material] != 0) glued = material;
        }
        if (corners <= 3 || !glued.exists()) continue;
        if (found.blocks++ == 0) {
            found.first = block;
            found.joint_material = glued;
        }
    }
    if (found.blocks < 2) return std::nullopt;
    return found;
}

}  // namespace rockslope::dda
