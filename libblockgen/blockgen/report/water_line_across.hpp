#pragma once

#include <vector>

#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The water table of a mesh from the left end of its blocks to their right one, level beyond its own ends;
/// empty where the mesh has none.
std::vector<Point> water_line_across(const BlockMesh& mesh);

}  // namespace rockslope::blockgen
