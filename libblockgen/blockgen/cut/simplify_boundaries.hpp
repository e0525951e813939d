#pragma once

#include <vector>

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The vertices that no neighbour needs: just two kept edges of one mark meet there, in a straight line. On
/// the outline of the rock straight is exact, so that its area stays; between blocks a bend of up to two grid
/// cells counts as straight, because that is what snapping makes of a straight joint. Taking the vertices out
/// makes no edge cross another or come near a foreign vertex.
/// @param marks per edge. @return per vertex, whether to take it out.
std::vector<char> redundant_vertices(const NodedEdges& noded, const Subdivision& subdivision,
                                     const FaceBlocks& faces, const BlockBoundary& boundary,
                                     const std::vector<EdgeMark>& marks);

}  // namespace rockslope::blockgen
