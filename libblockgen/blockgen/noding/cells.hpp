#pragma once

#include <cstdint>
#include <optional>

#include "blockgen/noding/snap_round.hpp"

namespace rockslope::blockgen {

/// The cell of a point of the fine grid.
GridPoint cell_of(const GridPoint& p, std::int64_t units_per_cell);

/// The centre of a cell on the fine grid.
constexpr GridPoint centre_of(const GridPoint& cell, std::int64_t units_per_cell) {
    return {cell.x * units_per_cell, cell.y * units_per_cell};
}

/// The cell that contains the crossing of two segments that are not parallel; nothing when they do not meet,
/// or meet in a common end, whose cell is hot anyway. Exact: doubles decide where their error bound allows
/// it, 128-bit integers elsewhere.
std::optional<GridPoint> crossing_cell(const FineSegment& s, const FineSegment& t,
                                       std::int64_t units_per_cell);

/// Whether a closed segment meets the half-open square of even width around a point.
bool intersects_square(const FineSegment& segment, const GridPoint& middle, std::int64_t width);

/// Whether a closed segment meets the half-open square of a cell.
inline bool intersects_cell(const FineSegment& segment, const GridPoint& cell, std::int64_t units_per_cell) {
    return intersects_square(segment, centre_of(cell, units_per_cell), units_per_cell);
}

}  // namespace rockslope::blockgen
