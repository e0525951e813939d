#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"

namespace rockslope::blockgen {

/// A change that the cutter makes to the given joints and blocks. Rounding to the grid, below half a cell, is
/// not reported as a change.
enum class ChangeKind : std::uint8_t {
    block_merged,          ///< a small block was merged with a neighbour
    piece_dropped,         ///< a joint's piece along a small block was dropped
    island_filled,         ///< blocks enclosed by another block were merged with it
    island_cut,            ///< a joint was added to connect an island to the boundary of the block around it
    end_joined,            ///< an end just short of another joint or of an outline was joined to it
    end_snapped,           ///< an end within `snap` of another joint or of an outline was moved to it
    near_miss,             ///< no change: an end stops short of something, one of more than chance explains
    piece_pruned,          ///< a joint's piece was pruned: it has the same block on both sides
    joint_repeated,        ///< a joint runs along an earlier one, which counts there and names the edge
    trace_outside,         ///< a given trace outside the rock was dropped
    trace_on_free_face,    ///< a given trace along a free face was dropped
    trace_without_length,  ///< a given trace shorter than the grid step was dropped
};

/// Name of a kind of change in the report.
const char* label_of(ChangeKind kind);

struct Change {
    ChangeKind kind = ChangeKind::block_merged;
    Point at;           ///< m: centroid of the block or hole, the end, or the midpoint of the piece or trace
    double area = 0;    ///< m2, of the block that was merged; 0 when there is none
    double length = 0;  ///< m, of the piece, the trace or the boundary removed; or the gap closed
    std::string joint;  ///< name of its set or trace; empty for several or none
    std::string other;  ///< to which an end was joined: name of a set or trace, or "outline"
};

/// Merged blocks, for the report.
struct MergeReport {
    std::size_t small_blocks = 0;    ///< blocks below the minimum area or roundness, before merging
    std::size_t merged_blocks = 0;   ///< decrease of the number of blocks by merging them
    double merged_area = 0;          ///< m2, of the small blocks that were merged
    double largest_merged = 0;       ///< m2, area of the largest of these
    std::size_t kept_small = 0;      ///< small blocks without a neighbour of the same rock
    std::size_t filled_islands = 0;  ///< blocks merged with the block that encloses them
    std::vector<Change> changes;     ///< one for each small block and each filled hole, in order of merging
};

/// The changes of joints by noding and pruning: ends joined, pieces pruned, given traces dropped. Sorted by
/// kind, then from left to right.
std::vector<Change> joint_changes(const CutContext& cut);

/// Sorts changes by kind, then from left to right.
void sort_changes(std::vector<Change>& changes);

}  // namespace rockslope::blockgen
