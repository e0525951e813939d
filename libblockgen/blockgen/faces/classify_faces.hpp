#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/faces/source_table.hpp"

namespace rockslope::blockgen {

/// Which block each face belongs to. Faces of one block are those that no joint, no outline, no change of
/// material and no excavation parts. Where excavations overlap, the rock goes with the earliest.
struct FaceBlocks {
    static constexpr std::int32_t outside = -1;
    std::vector<std::int32_t> block;       ///< per face; `outside` where there is no rock
    std::vector<std::int32_t> material;    ///< per block: 0 the domain's, k the k-th region's, counted from 1
    std::vector<std::int32_t> excavation;  ///< per block: index of the excavation that it goes with, or -1
    bool has_disjoint_voids = true;        ///< no hole or tunnel reaches beyond the rock or into another one
};

/// The name of a block's material.
const std::string& material_of(const FaceBlocks& faces, const SlopeModel& model, std::size_t block);

/// Whether two blocks are of one rock: one material, and both stay or go with the same excavation.
bool have_same_rock(const FaceBlocks& faces, const SlopeModel& model, std::size_t block, std::size_t other);

/// Flood fill from the unbounded face: crossing an outline goes in or out of it, an even number of times
/// changes nothing.
FaceBlocks classify_faces(const NodedEdges& noded, const Subdivision& subdivision, const SlopeModel& model,
                          const SourceTable& table);

}  // namespace rockslope::blockgen
