#pragma once

#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// The data of a cut: the noded lines and their subdivision, the block of each face, and the input.
/// References; the cutter owns the data.
struct CutContext {
    const NodedEdges& noded;
    const Subdivision& subdivision;
    const FaceBlocks& faces;
    const SlopeModel& model;
    const std::vector<Trace>& traces;
    const SourceTable& table;
    const ThreadPool& pool;

    FaceBlockIndex block_of(HalfEdgeIndex half_edge) const {
        return faces.block[subdivision.face[half_edge]];
    }
    /// Whether there is rock on the left of a half-edge.
    bool is_rock(HalfEdgeIndex half_edge) const { return block_of(half_edge) != FaceBlocks::outside; }
    /// Whether a joint runs along the edge. Its sources are sorted, and joints come last.
    bool is_joint(EdgeIndex edge) const { return table.is_joint(noded.sources_of(edge).back().source); }
};

}  // namespace rockslope::blockgen
