#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// References to the data of a cut that a report needs. The cutter owns the data.
struct CutContext {
    const NodedEdges& noded;
    const Subdivision& subdivision;
    const FaceBlocks& faces;
    const SlopeModel& model;
    const std::vector<Trace>& traces;
    const SourceTable& table;

    std::int32_t block_of(std::size_t half_edge) const { return faces.block[subdivision.face[half_edge]]; }
};

}  // namespace rockslope::blockgen
