#pragma once

#include <vector>

#include "blockgen/noding/node_joints.hpp"
#include "blockgen/noding/snap_round.hpp"

namespace rockslope::blockgen {

/// What runs along lines: line k has sources [first[k], first[k + 1]), each along it or back.
struct LineSources {
    std::vector<std::int32_t> first = {0};
    std::vector<EdgeSource> sources;
};

/// Puts the chains of snapped lines in the place of a network's vertices, edges and sources: equal links
/// become one edge, a chain that shrank to one cell is gone.
/// @param along the sources of the lines. @return per edge, whether a chain of other than two cells made it.
std::vector<char> link_chains(const SnappedChains& chains, const LineSources& along, NodedEdges& network);

/// The edges that may have come near another since the last round, and what a further round makes of them.
struct SnapRoundingPass {
    std::vector<std::int32_t> edges;  ///< ascending
    SnappedChains chains;             ///< one for each of `edges`

    bool is_fully_noded() const { return chains.items.size() == 2 * chains.size(); }
};

/// A round of snap rounding for edges between cells. Edges that did not change are known to be clean among
/// themselves: of these, only those near changed ones take part.
/// @param changed per edge; empty when all may have.
SnapRoundingPass snap_round_edges(std::span<const GridPoint> vertices,
                                  std::span<const std::pair<std::int32_t, std::int32_t>> edges,
                                  std::span<const char> changed);

/// The chains of all edges of a network when a round touched some.
SnappedChains chains_of_all_edges(const SnapRoundingPass& round, const NodedEdges& network);

}  // namespace rockslope::blockgen
