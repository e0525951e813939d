#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/noding/grid.hpp"
#include "blockgen/noding/indices.hpp"
#include "common/base/thread_pool.hpp"

namespace rockslope::blockgen {

/// A segment on the fine grid, before it is snapped to cells.
struct FineSegment {
    GridPoint a, b;
    friend auto operator<=>(const FineSegment&, const FineSegment&) = default;
};

/// The result of one round of snap rounding: segment k becomes the chain of hot cells
/// items[first[k]] ... items[first[k + 1] - 1].
struct SnappedChains {
    PerCell<GridPoint> cells;  ///< hot cells (hot pixels), sorted; a cell may be in no chain
    PerSegment<std::int64_t> first = {0};
    std::vector<CellIndex> items;

    std::size_t size() const { return first.size() - 1; }
    std::span<const CellIndex> chain(SegmentIndex k) const {
        return std::span(items).subspan(first[k], first[k + 1] - first[k]);
    }
};

/// The segments that a round of snap rounding bends, ascending, and their chains, one for each.
struct BentSegments {
    std::vector<SegmentIndex> segments;
    SnappedChains chains;
};

/// One round of snap rounding of segments between the centres of cells. A cell that contains an end or a
/// crossing is hot; a segment that passes through a further hot cell becomes the chain of the hot cells that
/// it passes through. Cell c covers [c - 1/2, c + 1/2) in both directions. Coordinates of the segments are
/// below 2^40. Time is linear in the number of segments, crossings and chain items for evenly spread joints.
/// @param units_per_cell width of a cell in fine-grid units, even.
/// @param ends the cells of all ends, sorted and distinct.
BentSegments bend_segments(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                           std::span<const GridPoint> ends, const ThreadPool& pool);

/// One round of snap rounding of segments that end anywhere, with two additions. A segment also passes
/// through the hot cell of an end that it passes within an eighth of a cell in x and y. Hot cells that touch
/// are merged: the first in `anchors` is kept, otherwise the smallest.
SnappedChains snap_round_merging_cells(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                                       std::span<const GridPoint> anchors, const ThreadPool& pool);

}  // namespace rockslope::blockgen
