#include "blockgen/noding/snap_round.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "blockgen/noding/bucket_grid.hpp"
#include "blockgen/noding/cells.hpp"
#include "common/base/parallel_collect.hpp"
#include "common/base/parallel_sort.hpp"

namespace rockslope::blockgen {

namespace {

struct CellHash {
    std::size_t operator()(const GridPoint& p) const {
        return static_cast<std::size_t>(p.x) * 0x9e3779b97f4a7c15u ^
               (static_cast<std::size_t>(p.y) + 0x7f4a7c15u) * 0xc2b2ae3d27d4eb4fu;
    }
};

/// The cells of all ends, sorted and distinct.
std::vector<GridPoint> end_cells(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                                 const ThreadPool& pool) {
    std::vector<GridPoint> cells;
    cells.reserve(2 * segments.size());
    for (const FineSegment& s : segments) {
        // The segments are sorted, so equal first ends are adjacent.
        const GridPoint first = cell_of(s.a, units_per_cell);
        if (cells.empty() || cells.back() != first) cells.push_back(first);
    }
    for (const FineSegment& s : segments) cells.push_back(cell_of(s.b, units_per_cell));
    parallel_sort(pool, cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

/// Appends the cells of the crossings of a bucket's segments that lie in the bucket. Two segments that cross
/// are listed together in the bucket of their crossing's cell, so that each crossing is found once.
void add_crossings(SegmentSpan<const FineSegment> segments, const BucketGrid& grid, std::size_t bucket,
                   std::int64_t units_per_cell, std::vector<GridPoint>& cells) {
    const auto near = grid.segments_of(bucket);
    for (std::size_t i = 0; i < near.size(); ++i)
        for (std::size_t j = i + 1; j < near.size(); ++j)
            if (const auto cell = crossing_cell(segments[near[i]], segments[near[j]], units_per_cell);
                cell && grid.bucket_of(centre_of(*cell, units_per_cell)) == bucket)
                cells.push_back(*cell);
}

/// The cells of all crossings, sorted and distinct. Columns of buckets follow each other in x, and no cell
/// has its centre in two of them.
std::vector<GridPoint> crossing_cells(SegmentSpan<const FineSegment> segments, const BucketGrid& grid,
                                      std::int64_t units_per_cell, const ThreadPool& pool) {
    const auto collect = [&](std::size_t begin, std::size_t end, std::vector<GridPoint>& cells) {
        for (std::size_t column = begin; column < end; ++column) {
            const auto start = static_cast<std::ptrdiff_t>(cells.size());
            for (std::size_t row = 0; row < grid.row_count(); ++row)
                add_crossings(segments, grid, column * grid.row_count() + row, units_per_cell, cells);
            std::sort(cells.begin() + start, cells.end());
            cells.erase(std::unique(cells.begin() + start, cells.end()), cells.end());
        }
    };
    return parallel_collect<GridPoint>(pool, grid.column_count(), collect);
}

/// The union of two sorted lists.
PerCell<GridPoint> all_cells(std::span<const GridPoint> ends, std::span<const GridPoint> crossings) {
    PerCell<GridPoint> cells;
    cells.reserve(ends.size() + crossings.size());
    std::set_union(ends.begin(), ends.end(), crossings.begin(), crossings.end(), std::back_inserter(cells));
    return cells;
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

/// The hot cells that segments pass through, ordered by cell. @param only_inner leaves out cells at whose
/// centre the segment ends.
std::vector<Hit> find_hits(SegmentSpan<const FineSegment> segments, CellSpan<const GridPoint> cells,
                           const BucketGrid& grid, std::int64_t units_per_cell, bool only_inner,
                           const ThreadPool& pool) {
    const auto collect = [&](std::size_t begin, std::size_t end, std::vector<Hit>& hits) {
        for (const CellIndex c : indices<CellIndex>(begin, end)) {
            const GridPoint centre = centre_of(cells[c], units_per_cell);
            for (const SegmentIndex s : grid.segments_of(grid.bucket_of(centre))) {
                if (only_inner && (segments[s].a == centre || segments[s].b == centre)) continue;
                if (intersects_cell(segments[s], cells[c], units_per_cell)) hits.push_back({s, c});
            }
        }
    };
    return parallel_collect<Hit>(pool, cells.size(), collect);
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

/// The hits of segments that pass an end within an eighth of a cell but miss the end's cell. An end that
/// near another joint is then joined to it, wherever the end lies in its cell.
std::vector<Hit> hits_near_ends(SegmentSpan<const FineSegment> segments, CellSpan<const GridPoint> cells,
                                const BucketGrid& grid, std::int64_t units_per_cell, const ThreadPool& pool) {
    // Wider squares bend segments so far that an outline may overlap itself on coarse grids.
    const std::int64_t width = units_per_cell / 8 * 2;
    const auto add = [&](SegmentIndex ending, const GridPoint& end, std::vector<Hit>& hits) {
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
    return parallel_collect<Hit>(pool, segments.size(),
                                 [&](std::size_t begin, std::size_t end, std::vector<Hit>& hits) {
                                     for (const SegmentIndex k : indices<SegmentIndex>(begin, end))
                                         add(k, segments[k].a, hits), add(k, segments[k].b, hits);
                                 });
}

/// The cells that each segment passes through: those of segment k are [first[k], first[k + 1]).
struct CellsOfSegments {
    PerSegment<std::int64_t> first;
    std::vector<CellIndex> cells;
};

/// The hits grouped by segment (counting sort), otherwise in their order.
CellsOfSegments group_by_segment(const std::vector<Hit>& hits, std::size_t segments) {
    CellsOfSegments result{PerSegment<std::int64_t>(segments + 1, 0), std::vector<CellIndex>(hits.size())};
    for (const Hit& hit : hits) ++result.first[hit.segment + 1];
    for (const SegmentIndex k : indices<SegmentIndex>(segments)) result.first[k + 1] += result.first[k];
    PerSegment<std::int64_t> fill(result.first.begin(), result.first.end() - 1);
    for (const Hit& hit : hits) result.cells[fill[hit.segment]++] = hit.cell;
    return result;
}

/// Orders the cells that each segment passes through along it.
void order_along(SegmentSpan<const FineSegment> segments, CellSpan<const GridPoint> cells,
                 std::int64_t units_per_cell, CellsOfSegments& near, const ThreadPool& pool) {
    pool.parallel_for(segments.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<std::pair<Int128, CellIndex>> ordered;
        for (const SegmentIndex k : indices<SegmentIndex>(begin, end)) {
            const auto part = std::span(near.cells).subspan(near.first[k], near.first[k + 1] - near.first[k]);
            ordered.clear();
            for (const CellIndex c : part)
                ordered.emplace_back(distance_along(segments[k], cells[c], units_per_cell), c);
            // Cells come from left to right, as most segments pass through them.
            if (std::is_sorted(ordered.begin(), ordered.end())) continue;
            std::sort(ordered.begin(), ordered.end());
            for (std::size_t i = 0; i < part.size(); ++i) part[i] = ordered[i].second;
        }
    });
}

/// The chains of cells along the segments, in which a cell stands for those merged with it.
SnappedChains chains_of(CellsOfSegments near, PerCell<GridPoint> cells,
                        CellSpan<const CellIndex> representative_of) {
    SnappedChains chains;
    chains.cells = std::move(cells);
    chains.first.reserve(near.first.size());
    std::size_t kept = 0;
    for (const SegmentIndex k : indices<SegmentIndex>(near.first.size() - 1)) {
        const std::size_t start = kept;
        for (std::int64_t i = near.first[k]; i < near.first[k + 1]; ++i) {
            const CellIndex cell = representative_of[near.cells[i]];
            if (kept == start || near.cells[kept - 1] != cell) near.cells[kept++] = cell;
        }
        chains.first.push_back(kept);
    }
    near.cells.resize(kept);
    chains.items = std::move(near.cells);
    return chains;
}

/// The hits of bent segments, and of their ends, with these segments numbered anew in `bent`.
std::vector<Hit> hits_of_bent(SegmentSpan<const FineSegment> segments, CellSpan<const GridPoint> cells,
                              std::int64_t units_per_cell, std::vector<Hit> inner,
                              std::vector<SegmentIndex>& bent) {
    for (const Hit& hit : inner) bent.push_back(hit.segment);
    std::sort(bent.begin(), bent.end());
    bent.erase(std::unique(bent.begin(), bent.end()), bent.end());
    for (Hit& hit : inner)
        hit.segment = std::lower_bound(bent.begin(), bent.end(), hit.segment) - bent.begin();
    for (std::size_t k = 0; k < bent.size(); ++k)
        for (const GridPoint& end : {segments[bent[k]].a, segments[bent[k]].b}) {
            const auto found = std::lower_bound(cells.begin(), cells.end(), cell_of(end, units_per_cell));
            inner.push_back({k, found - cells.begin()});
        }
    return inner;
}

}  // namespace

BentSegments bend_segments(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                           std::span<const GridPoint> ends, const ThreadPool& pool) {
    const BucketGrid grid(segments, units_per_cell, {}, pool);
    std::vector<GridPoint> crossings = crossing_cells(segments, grid, units_per_cell, pool);
    std::erase_if(crossings,
                  [&](const GridPoint& c) { return std::binary_search(ends.begin(), ends.end(), c); });
    PerCell<GridPoint> with_crossings;
    if (!crossings.empty()) with_crossings = all_cells(ends, crossings);
    const CellSpan<const GridPoint> cells =
        crossings.empty() ? CellSpan<const GridPoint>(ends) : CellSpan<const GridPoint>(with_crossings);
    const std::vector<Hit> inner = find_hits(segments, cells, grid, units_per_cell, true, pool);

    BentSegments result;
    if (inner.empty()) return result;
    const std::vector<Hit> hits = hits_of_bent(segments, cells, units_per_cell, inner, result.segments);
    PerSegment<FineSegment> lines;
    for (const SegmentIndex k : result.segments) lines.push_back(segments[k]);
    CellsOfSegments near = group_by_segment(hits, lines.size());
    order_along(lines, cells, units_per_cell, near, pool);
    result.chains.cells.assign(cells.begin(), cells.end());
    result.chains.first = std::move(near.first);
    result.chains.items = std::move(near.cells);
    return result;
}

SnappedChains snap_round_merging_cells(SegmentSpan<const FineSegment> segments, std::int64_t units_per_cell,
                                       std::span<const GridPoint> anchors, const ThreadPool& pool) {
    const BucketGrid grid(segments, units_per_cell, {}, pool);
    PerCell<GridPoint> cells = all_cells(end_cells(segments, units_per_cell, pool),
                                         crossing_cells(segments, grid, units_per_cell, pool));
    const PerCell<CellIndex> representative_of = representatives(cells, anchors);
    std::vector<Hit> hits = find_hits(segments, cells, grid, units_per_cell, false, pool);
    const std::vector<Hit> more = hits_near_ends(segments, cells, grid, units_per_cell, pool);
    hits.insert(hits.end(), more.begin(), more.end());
    CellsOfSegments near = group_by_segment(hits, segments.size());
    hits = {};
    order_along(segments, cells, units_per_cell, near, pool);
    return chains_of(std::move(near), std::move(cells), representative_of);
}

}  // namespace rockslope::blockgen
