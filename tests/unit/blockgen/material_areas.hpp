#pragma once

#include <map>
#include <string>

#include "blockgen/mesh/measures.hpp"

namespace rockslope::blockgen {

/// The area of the blocks of each block material, m2.
inline std::map<std::string, double> material_areas(const BlockMesh& mesh) {
    std::map<std::string, double> areas;
    for (const BlockIndex b : mesh.blocks())
        areas[mesh.block_materials[mesh.block_material[b]]] += block_area(mesh, b);
    return areas;
}

}  // namespace rockslope::blockgen
