#pragma once

#include <vector>

#include "blockgen/noding/node_joints.hpp"
#include "blockgen/noding/snap_round.hpp"

namespace rockslope::blockgen {

/// The sources that run along each line, in either direction: those of line k are [first[k], first[k + 1]).
struct LineSources {
    PerSegment<std::int32_t> first = {0};
    std::vector<EdgeSource> sources;
};

/// Replaces a network's vertices, edges and sources by those of the chains of snapped lines. Equal links are
/// merged into one edge; a chain collapsed to one cell is dropped.
/// @param along the sources of the lines. @return whether each edge came from a chain with more than two
/// cells, and so changed.
PerEdge<char> link_chains(const SnappedChains& chains, const LineSources& along, NodedEdges& network,
                          const ThreadPool& pool = ThreadPool());

/// One round of snap rounding: the edges that it bends, and their chains.
struct SnapRoundingPass {
    PerSegment<EdgeIndex> edges;  ///< ascending
    SnappedChains chains;         ///< one for each of `edges`

    bool is_fully_noded() const { return edges.empty(); }
};

/// One round of snap rounding of edges between cells. Unchanged edges are properly noded among themselves, so
/// only changed edges and unchanged edges near them are rounded.
/// @param changed flag per edge; empty when all edges may have changed.
SnapRoundingPass snap_round_edges(NodeSpan<const GridPoint> vertices, EdgeSpan<const EdgeEnds> edges,
                                  EdgeSpan<const char> changed, const ThreadPool& pool = ThreadPool());

/// The chains of all edges of a network: those of the round, and two vertices for each edge not in it.
SnappedChains chains_of_all_edges(const SnapRoundingPass& round, const NodedEdges& network);

}  // namespace rockslope::blockgen
