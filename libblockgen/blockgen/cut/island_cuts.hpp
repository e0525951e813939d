#pragma once

#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// Joints that lead from each island to the rim of the block round it: the island's own joints at its two
/// outermost corners, in order of x, prolonged in their own direction until they meet an edge of that block.
/// They bear the name "island cut" and the material of the joint that they prolong. An island whose rim
/// touches that of the block needs one only. Empty when there is no island.
std::vector<Trace> island_cuts(const BlockMesh& mesh);

}  // namespace rockslope::blockgen
