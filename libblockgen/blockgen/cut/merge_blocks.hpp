#pragma once

#include <vector>

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/faces/cut_context.hpp"
#include "blockgen/mesh/block_mesh.hpp"
#include "blockgen/report/changes.hpp"

namespace rockslope::blockgen {

/// Merges blocks that are too small or too slender with neighbours of the same rock, the smallest first,
/// until no such block can be merged. SmallBlockPolicy::merge: with the neighbour across the longest common
/// boundary. SmallBlockPolicy::drop: with all neighbours across the block's shortest joint, whose piece along
/// the block is dropped. The total area does not change. @return the blocks after merging.
FaceBlocks merge_small_blocks(const CutContext& cut, MergeReport& report);

/// Merges all blocks that a block encloses with that block; cavities remain. @return the blocks after
/// merging. @throws InputError located at [domain] when their materials or excavations differ.
FaceBlocks fill_islands(const CutContext& cut, const BlockRings& blocks, MergeReport& report);

/// Joints that connect each island to the boundary of the block that encloses it. At the island's leftmost
/// and rightmost corners one of its joints is extended in its own direction to the next edge of that block. A
/// cut is named "island cut" and has the material of the joint that it extends. Empty when there is no
/// island.
std::vector<Trace> island_cuts(const BlockMesh& mesh);

/// Whether another block lies beyond at least one half-edge of a ring, so that the hole is not only a cavity.
bool encloses_rock(RingSpan ring, const Subdivision& subdivision, const FaceBlocks& faces);

}  // namespace rockslope::blockgen
