#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// What cleaning did to joints and blocks. Rounding to the grid, below half a cell, is no change.
enum class ChangeKind : std::uint8_t {
    block_merged,          ///< a small block became part of its neighbour
    piece_dropped,         ///< a joint's piece along a small block was taken out
    island_filled,         ///< what a block enclosed became part of it
    island_cut,            ///< a joint was added to lead an island to the rim
    end_joined,            ///< an end that stopped short of another joint or of an outline now lies on it
    piece_pruned,          ///< a joint's piece has one block on both sides, so it parts nothing
    trace_outside,         ///< a given trace lies beyond the rock
    trace_on_free_face,    ///< a given trace runs along a free face
    trace_without_length,  ///< a given trace is shorter than the grid
};

/// A change in words, as the report names it.
const char* label_of(ChangeKind kind);

struct Change {
    ChangeKind kind = ChangeKind::block_merged;
    Point at;           ///< m: centroid of the block or hole, the end, or the middle of the piece or trace
    double area = 0;    ///< m2, of the block that is gone; 0 where none is
    double length = 0;  ///< m, of the piece, the trace or the boundary taken out; the gap that was closed
    std::string joint;  ///< name of its set or trace; empty where several or none
    std::string other;  ///< what an end was joined to: name of a set or trace, or "outline"
};

/// What was joined, for the report.
struct MergeReport {
    std::size_t small_blocks = 0;    ///< blocks below the wanted size or roundness, before merging
    std::size_t merged_blocks = 0;   ///< how many fewer blocks there are because of them
    double merged_area = 0;          ///< m2, of the small blocks that are gone
    std::size_t kept_small = 0;      ///< small blocks without a neighbour of their own material
    std::size_t filled_islands = 0;  ///< blocks that became one with the block round them
    std::vector<Change> changes;     ///< a row for each small block and each filled hole, in their order
};

/// The changes that noding and pruning made to joints: ends joined, pieces pruned, given traces dropped. In
/// the order of the kinds, each kind from left to right.
std::vector<Change> joint_changes(const NodedEdges& noded, const Subdivision& subdivision,
                                  const FaceBlocks& faces, const SlopeModel& model,
                                  const std::vector<Trace>& traces, const SourceTable& table);

/// Puts changes in the order of the kinds, each kind from left to right.
void sort_changes(std::vector<Change>& changes);

}  // namespace rockslope::blockgen
