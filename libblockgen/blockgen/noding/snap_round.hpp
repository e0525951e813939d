#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/noding/grid.hpp"

namespace rockslope::blockgen {

/// A segment on a grid finer than the cells to which it is snapped.
struct FineSegment {
    GridPoint a, b;
    friend auto operator<=>(const FineSegment&, const FineSegment&) = default;
};

/// What one round of snap rounding makes of each segment: segment k becomes the chain of the cells with the
/// numbers [first[k], first[k + 1]) of `items`.
struct SnappedChains {
    std::vector<GridPoint> cells;  ///< the hot ones, sorted; some may be in no chain
    std::vector<std::int64_t> first = {0};
    std::vector<std::int32_t> items;  ///< indices into `cells`

    std::size_t size() const { return first.size() - 1; }
    std::span<const std::int32_t> chain(std::size_t k) const {
        return std::span(items).subspan(static_cast<std::size_t>(first[k]),
                                        static_cast<std::size_t>(first[k + 1] - first[k]));
    }
};

/// One round: the cells that hold an end or a crossing are hot; each segment becomes the chain of the hot
/// cells it passes through. Cell c covers [c - 1/2, c + 1/2) in both directions, and is `units_per_cell`
/// units of the segments wide.
/// @param units_per_cell even. @param ends the cells of all ends, sorted and distinct.
/// Coordinates of the segments below 2^40. Time is linear in segments, crossings and chain lengths for evenly
/// spread joints.
SnappedChains snap_round(std::span<const FineSegment> segments, std::int64_t units_per_cell,
                         std::vector<GridPoint> ends);

/// The same, but a segment that passes an end within an eighth of a cell, in both directions, passes its
/// cell, too; and hot cells that touch become one: the first of `anchors` wins, then the smallest.
SnappedChains snap_round_merging_cells(std::span<const FineSegment> segments, std::int64_t units_per_cell,
                                       std::span<const GridPoint> anchors);

}  // namespace rockslope::blockgen
