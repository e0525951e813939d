#pragma once

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/faces/cut_context.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// Finds redundant vertices: vertices where exactly two boundary edges of the same mark meet in a straight
/// line. On the outline of the rock, straight is exact, so that the area does not change. Between blocks a
/// deviation of up to two grid cells is allowed, because snap rounding bends a straight joint by as much.
/// Removing the vertices leaves the edges properly noded and inverts no ring.
/// @return whether to remove each vertex.
PerNode<char> redundant_vertices(const CutContext& cut, const BlockBoundary& boundary,
                                 const PerEdge<EdgeMark>& marks);

}  // namespace rockslope::blockgen
