#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// What a report on a cut is drawn up from. It refers to what the cutter owns.
struct CutContext {
    const NodedEdges& noded;
    const Subdivision& subdivision;
    const FaceBlocks& faces;
    const SlopeModel& model;
    const std::vector<Trace>& traces;
    const SourceTable& table;

    std::int32_t block_of(std::size_t half_edge) const {
        return faces.block[static_cast<std::size_t>(subdivision.face[half_edge])];
    }
};

}  // namespace rockslope::blockgen
