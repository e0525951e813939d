#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/detail/arrange.hpp"
#include "blockgen/source_table.hpp"

namespace blockgen {

/// Which block each face belongs to. Faces of one block are those that no joint, no outline and no change of
/// material parts.
struct FaceBlocks {
    static constexpr std::int32_t outside = -1;
    std::vector<std::int32_t> block;     ///< per face; `outside` where there is no rock
    std::vector<std::int32_t> material;  ///< per block: 0 the domain's, k the k-th region's, counted from 1
    bool plain_rings = true;             ///< no hole or tunnel reaches beyond the rock or into another one
};

/// Flood fill from the unbounded face: crossing an outline goes in or out of it, an even number of times
/// changes nothing.
FaceBlocks classify_faces(const NodedEdges& noded, const Subdivision& subdivision, const SlopeModel& model,
                          const SourceTable& table);

}  // namespace blockgen
