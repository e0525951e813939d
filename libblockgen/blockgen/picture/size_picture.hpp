#pragma once

#include "blockgen/mesh/block_mesh.hpp"
#include "common/drawing/canvas.hpp"

namespace rockslope::blockgen {

/// The distribution of block areas: the share of the area, and of the number, of the blocks up to a size,
/// over a logarithmic scale, with D10, D50 and D90 by area marked.
Canvas draw_sizes(const BlockMesh& mesh);

}  // namespace rockslope::blockgen
