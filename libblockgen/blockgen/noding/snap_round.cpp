#include "blockgen/noding/snap_round.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "blockgen/noding/bucket_grid.hpp"

namespace rockslope::blockgen {

namespace {

Int128 floor_division(Int128 numerator, Int128 denominator) {
    const Int128 quotient = numerator / denominator;
    return numerator % denominator < 0 ? quotient - 1 : quotient;
}

/// The cell of a point of the fine grid.
GridPoint cell_of(const GridPoint& p, std::int64_t units_per_cell) {
    const auto cell = [units_per_cell](std::int64_t x) {
        const std::int64_t shifted = x + units_per_cell / 2;
        return shifted >= 0 ? shifted / units_per_cell : -((-shifted + units_per_cell - 1) / units_per_cell);
    };
    return {cell(p.x), cell(p.y)};
}

/// The cell that contains the crossing of two segments that are not parallel; nothing when they do not meet,
/// or meet in a common end, whose cell is hot anyway. For segments a-b and c-d the crossing is a + t (b - a)
/// with t = ((c - a) x (d - c)) / ((b - a) x (d - c)).
std::optional<GridPoint> crossing_cell(const FineSegment& s, const FineSegment& t,
                                       std::int64_t units_per_cell) {
    if (std::max(s.a.x, s.b.x) < std::min(t.a.x, t.b.x) || std::max(t.a.x, t.b.x) < std::min(s.a.x, s.b.x) ||
        std::max(s.a.y, s.b.y) < std::min(t.a.y, t.b.y) || std::max(t.a.y, t.b.y) < std::min(s.a.y, s.b.y))
        return std::nullopt;
    if (s.a == t.a || s.b == t.b || s.a == t.b || s.b == t.a) return std::nullopt;
    const Int128 ux = s.b.x - s.a.x, uy = s.b.y - s.a.y, vx = t.b.x - t.a.x, vy = t.b.y - t.a.y;
    const Int128 wx = t.a.x - s.a.x, wy = t.a.y - s.a.y;
    Int128 denominator = ux * vy - uy * vx;
    if (denominator == 0) return std::nullopt;
    Int128 along_s = wx * vy - wy * vx, along_t = wx * uy - wy * ux;
    if (denominator < 0) denominator = -denominator, along_s = -along_s, along_t = -along_t;
    if (along_s < 0 || along_s > denominator || along_t < 0 || along_t > denominator) return std::nullopt;
    const auto cell = [&](std::int64_t start, Int128 component) {
        const Int128 numerator = along_s * component + (start + units_per_cell / 2) * denominator;
        return static_cast<std::int64_t>(floor_division(numerator, denominator * units_per_cell));
    };
    return GridPoint{cell(s.a.x, ux), cell(s.a.y, uy)};
}

/// Floating-point filter: whether the line a-b certainly misses a square. True only when its distance from
/// the centre exceeds that of every corner by more than the rounding error.
bool certainly_misses(const GridPoint& a, const GridPoint& b, const GridPoint& middle, std::int64_t width) {
    const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const double first = static_cast<double>(middle.x - a.x) * dy;
    const double second = static_cast<double>(middle.y - a.y) * dx;
    const double reach = (std::abs(dx) + std::abs(dy)) * static_cast<double>(width) / 2;
    return std::abs(first - second) > reach * (1 + 1e-12) + 1e-14 * (std::abs(first) + std::abs(second));
}

/// Whether a closed segment meets the half-open square of even width around a point.
bool intersects_square(const FineSegment& segment, const GridPoint& middle, std::int64_t width) {
    const std::int64_t half = width / 2;
    const std::int64_t left = middle.x - half, right = left + width;
    const std::int64_t bottom = middle.y - half, top = bottom + width;
    GridPoint a = segment.a, b = segment.b;
    if (b < a) std::swap(a, b);
    const std::int64_t low_y = std::min(a.y, b.y), high_y = std::max(a.y, b.y);
    if (b.x < left || a.x >= right || high_y < bottom || low_y >= top) return false;
    if (a.x == b.x || low_y == high_y) return true;
    const auto holds = [&](const GridPoint& p) {
        return p.x >= left && p.x < right && p.y >= bottom && p.y < top;
    };
    if (holds(a) || holds(b)) return true;
    if (certainly_misses(a, b, middle, width)) return false;

    const int lower_left = side_of(a, b, {left, bottom}), lower_right = side_of(a, b, {right, bottom});
    const int upper_left = side_of(a, b, {left, top}), upper_right = side_of(a, b, {right, top});
    const int lowest = std::min({lower_left, lower_right, upper_left, upper_right});
    const int highest = std::max({lower_left, lower_right, upper_left, upper_right});
    if (lowest < 0 && highest > 0 && b.x > left && a.x < right && high_y > bottom && low_y < top) return true;
    // Left and bottom sides belong to the square. The segment runs from left to right.
    if (a.x <= left && b.x >= left && lower_left <= 0 && upper_left > 0) return true;
    const bool rises = a.y < b.y;
    return low_y <= bottom && high_y >= bottom &&
           (rises ? lower_left >= 0 && lower_right < 0 : lower_left <= 0 && lower_right > 0);
}

/// Whether a closed segment meets the half-open square of a cell.
bool intersects_cell(const FineSegment& segment, const GridPoint& cell, std::int64_t units_per_cell) {
    return intersects_square(segment, {cell.x * units_per_cell, cell.y * units_per_cell}, units_per_cell);
}

struct CellHash {
    std::size_t operator()(const GridPoint& p) const {
        return static_cast<std::size_t>(p.x) * 0x9e3779b97f4a7c15u ^
               (static_cast<std::size_t>(p.y) + 0x7f4a7c15u) * 0xc2b2ae3d27d4eb4fu;
    }
};

std::vector<GridPoint> end_cells(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell) {
    std::vector<GridPoint> cells;
    cells.reserve(2 * segments.size());
    for (const FineSegment& s : segments) {
        // The segments are sorted, so equal first ends are adjacent.
        const GridPoint first = cell_of(s.a, units_per_cell);
        if (cells.empty() || cells.back() != first) cells.push_back(first);
    }
    for (const FineSegment& s : segments) cells.push_back(cell_of(s.b, units_per_cell));
    return cells;
}

void sort_distinct(std::vector<GridPoint>& cells) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

std::vector<GridPoint> crossing_cells(SegmentSpan<const FineSegment> segments, const BucketGrid& grid,
                                      std::int64_t units_per_cell) {
    std::vector<GridPoint> cells;
    for (std::size_t bucket = 0; bucket < grid.bucket_count(); ++bucket) {
        const auto near = grid.segments_of(bucket);
        for (std::size_t i = 0; i < near.size(); ++i)
            for (std::size_t j = i + 1; j < near.size(); ++j)
                if (const auto cell = crossing_cell(segments[near[i]], segments[near[j]], units_per_cell))
                    cells.push_back(*cell);
    }
    return cells;
}

/// @param ends sorted and distinct. @return the union of ends and crossings, sorted and distinct.
std::vector<GridPoint> with_crossings(std::vector<GridPoint> ends, std::vector<GridPoint> crossings) {
    std::erase_if(crossings,
                  [&](const GridPoint& c) { return std::binary_search(ends.begin(), ends.end(), c); });
    if (crossings.empty()) return ends;
    sort_distinct(crossings);
    const auto middle = static_cast<std::ptrdiff_t>(ends.size());
    ends.insert(ends.end(), crossings.begin(), crossings.end());
    std::inplace_merge(ends.begin(), ends.begin() + middle, ends.end());
    return ends;
}

/// Flags the cells of a sorted list that touch another cell of the list at a side or a corner.
PerCell<char> touching(CellSpan<const GridPoint> cells) {
    PerCell<char> touches(cells.size(), 0);
    CellIndex other = 0;
    for (const CellIndex k : cells.indices()) {
        const auto mark = [&](CellIndex j) { touches[k] = touches[j] = 1; };
        if (k + 1 < cells.size() && cells[k + 1].x == cells[k].x && cells[k + 1].y == cells[k].y + 1)
            mark(k + 1);
        const GridPoint lowest{cells[k].x + 1, cells[k].y - 1};
        while (other < cells.size() && cells[other] < lowest) ++other;
        for (CellIndex j = other; j < cells.size() && cells[j].x == lowest.x && cells[j].y <= lowest.y + 2;
             ++j)
            mark(j);
    }
    return touches;
}

/// The representative of each hot cell: itself, or a touching cell chosen before it. Anchors are chosen
/// first; they are hot.
PerCell<CellIndex> representatives(CellSpan<const GridPoint> cells, std::span<const GridPoint> anchors) {
    const PerCell<char> touches = touching(cells);
    std::unordered_map<GridPoint, char, CellHash> chosen;
    const auto choose = [&chosen](const GridPoint& cell) {
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                if (const GridPoint near{cell.x + dx, cell.y + dy}; chosen.contains(near)) return near;
        chosen.emplace(cell, 0);
        return cell;
    };
    for (const GridPoint& anchor : anchors) choose(anchor);
    PerCell<CellIndex> result(cells.size());
    for (const CellIndex k : cells.indices()) {
        result[k] = k;
        if (!touches[k] || chosen.contains(cells[k])) continue;
        const auto found = std::lower_bound(cells.begin(), cells.end(), choose(cells[k]));
        result[k] = found - cells.begin();
    }
    return result;
}

struct Hit {
    SegmentIndex segment;
    CellIndex cell;
};

std::vector<Hit> find_hits(SegmentSpan<const FineSegment> segments, CellSpan<const GridPoint> cells,
                           const BucketGrid& grid, std::int64_t units_per_cell) {
    std::vector<Hit> hits;
    for (const CellIndex c : cells.indices()) {
        const GridPoint centre{cells[c].x * units_per_cell, cells[c].y * units_per_cell};
        for (const SegmentIndex s : grid.segments_of(grid.bucket_of(centre)))
            if (intersects_cell(segments[s], cells[c], units_per_cell)) hits.push_back({s, c});
    }
    return hits;
}

/// Position of a cell's centre along a segment, scaled by the segment's length.
Int128 distance_along(const FineSegment& s, const GridPoint& cell, std::int64_t units_per_cell) {
    return static_cast<Int128>(cell.x * units_per_cell - s.a.x) * (s.b.x - s.a.x) +
           static_cast<Int128>(cell.y * units_per_cell - s.a.y) * (s.b.y - s.a.y);
}

/// Whether a cell lies between the end cells of a segment, so that the segment can bend to it and keep its
/// ends.
bool lies_between_ends(const FineSegment& s, const GridPoint& cell, std::int64_t units_per_cell) {
    const Int128 distance = distance_along(s, cell, units_per_cell);
    return distance > distance_along(s, cell_of(s.a, units_per_cell), units_per_cell) &&
           distance < distance_along(s, cell_of(s.b, units_per_cell), units_per_cell);
}

/// Adds hits of segments that pass an end within an eighth of a cell but miss the end's cell. An end that
/// near another joint is then joined to it, wherever the end lies in its cell.
void add_hits_near_ends(SegmentSpan<const FineSegment> segments, CellSpan<const GridPoint> cells,
                        const BucketGrid& grid, std::int64_t units_per_cell, std::vector<Hit>& hits) {
    // Wider squares bend segments so far that an outline may overlap itself on coarse grids.
    const std::int64_t width = units_per_cell / 8 * 2;
    const auto add = [&](SegmentIndex ending, const GridPoint& end) {
        for (const SegmentIndex s : grid.segments_of(grid.bucket_of(end))) {
            if (s == ending || !intersects_square(segments[s], end, width)) continue;
            const GridPoint cell = cell_of(end, units_per_cell);
            if (intersects_cell(segments[s], cell, units_per_cell) ||
                !lies_between_ends(segments[s], cell, units_per_cell))
                continue;
            const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
            hits.push_back({s, found - cells.begin()});
        }
    };
    for (const SegmentIndex k : segments.indices()) add(k, segments[k].a), add(k, segments[k].b);
}

/// The cells that each segment passes through, unordered: those of segment k are [first[k], first[k + 1]).
struct CellsOfSegments {
    PerSegment<std::int64_t> first;
    std::vector<CellIndex> cells;
};

/// The hits grouped by segment (counting sort).
CellsOfSegments group_by_segment(const std::vector<Hit>& hits, std::size_t segments) {
    CellsOfSegments result{PerSegment<std::int64_t>(segments + 1, 0), std::vector<CellIndex>(hits.size())};
    for (const Hit& hit : hits) ++result.first[hit.segment + 1];
    for (const SegmentIndex k : indices<SegmentIndex>(segments)) result.first[k + 1] += result.first[k];
    PerSegment<std::int64_t> fill(result.first.begin(), result.first.end() - 1);
    for (const Hit& hit : hits) result.cells[fill[hit.segment]++] = hit.cell;
    return result;
}

/// Orders the hits along each segment. @param representative_of empty when no cells are merged.
SnappedChains chains_of(SegmentSpan<const FineSegment> segments, PerCell<GridPoint> cells,
                        const std::vector<Hit>& hits, std::int64_t units_per_cell,
                        CellSpan<const CellIndex> representative_of) {
    const CellsOfSegments near = group_by_segment(hits, segments.size());
    SnappedChains chains;
    chains.first.reserve(segments.size() + 1);
    chains.items.reserve(near.cells.size());
    std::vector<std::pair<Int128, CellIndex>> ordered;
    for (const SegmentIndex k : segments.indices()) {
        ordered.clear();
        for (std::int64_t i = near.first[k]; i < near.first[k + 1]; ++i) {
            const CellIndex cell = near.cells[i];
            ordered.emplace_back(distance_along(segments[k], cells[cell], units_per_cell), cell);
        }
        std::sort(ordered.begin(), ordered.end());
        const std::size_t start = chains.items.size();
        for (const auto& [distance, c] : ordered) {
            const CellIndex cell = representative_of.empty() ? c : representative_of[c];
            if (chains.items.size() == start || chains.items.back() != cell) chains.items.push_back(cell);
        }
        chains.first.push_back(chains.items.size());
    }
    chains.cells = std::move(cells);
    return chains;
}

}  // namespace

SnappedChains snap_round(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                         std::vector<GridPoint> ends) {
    const BucketGrid grid(segments, units_per_cell);
    PerCell<GridPoint> cells =
        with_crossings(std::move(ends), crossing_cells(segments, grid, units_per_cell));
    const std::vector<Hit> hits = find_hits(segments, cells, grid, units_per_cell);
    return chains_of(segments, std::move(cells), hits, units_per_cell, {});
}

SnappedChains snap_round_merging_cells(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                                       std::span<const GridPoint> anchors) {
    const BucketGrid grid(segments, units_per_cell);
    std::vector<GridPoint> cells = end_cells(segments, units_per_cell);
    const std::vector<GridPoint> crossings = crossing_cells(segments, grid, units_per_cell);
    cells.insert(cells.end(), crossings.begin(), crossings.end());
    sort_distinct(cells);
    const PerCell<CellIndex> representative_of = representatives(cells, anchors);
    std::vector<Hit> hits = find_hits(segments, cells, grid, units_per_cell);
    add_hits_near_ends(segments, cells, grid, units_per_cell, hits);
    return chains_of(segments, std::move(cells), hits, units_per_cell, representative_of);
}

}  // namespace rockslope::blockgen
