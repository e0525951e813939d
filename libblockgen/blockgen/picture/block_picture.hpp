#pragma once

#include <string>

#include "blockgen/mesh/block_mesh.hpp"
#include "blockgen/picture/canvas.hpp"

namespace blockgen {

/// The section on a page: blocks filled by material, joints coloured by set, fixed and prescribed blocks
/// hatched, measured points named, bolts drawn; axes in metres, scale bar and legends.
Canvas draw_blocks(const BlockMesh& mesh);

}  // namespace blockgen
