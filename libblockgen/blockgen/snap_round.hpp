#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/grid.hpp"

namespace blockgen {

/// A segment on a grid finer than the cells to which it is snapped.
struct FineSegment {
    GridPoint a, b;
    friend auto operator<=>(const FineSegment&, const FineSegment&) = default;
};

/// What one round of snap rounding makes of each segment: segment k becomes the chain of cells [first[k],
/// first[k + 1]).
struct SnappedChains {
    std::vector<std::int64_t> first = {0};
    std::vector<GridPoint> cells;

    std::span<const GridPoint> chain(std::size_t k) const {
        return std::span(cells).subspan(static_cast<std::size_t>(first[k]),
                                        static_cast<std::size_t>(first[k + 1] - first[k]));
    }
};

/// One round: the cells that hold an end or a crossing are hot; each segment becomes the chain of the hot
/// cells it passes through. Cell c covers [c - 1/2, c + 1/2) in both directions, and is `fineness` units of
/// the segments wide.
/// @param fineness even. @param join_adjacent hot cells that touch become one; the first of `anchors` wins,
/// then the smallest. Coordinates of the segments below 2^40. Time is linear in segments, crossings and chain
/// lengths for evenly spread joints.
SnappedChains snap_round(std::span<const FineSegment> segments, std::int64_t fineness, bool join_adjacent,
                         std::span<const GridPoint> anchors = {});

}  // namespace blockgen
