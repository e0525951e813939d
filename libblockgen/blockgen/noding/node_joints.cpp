#include "blockgen/noding/node_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "blockgen/noding/link_chains.hpp"
#include "blockgen/noding/snap_round.hpp"
#include "common/base/parallel_sort.hpp"

namespace rockslope::blockgen {

namespace {

constexpr std::int64_t extent_limit = std::int64_t{1} << 38;

/// A piece between two points of the fine grid, the smaller first, and the source along it.
struct SegmentPiece {
    FineSegment line;
    EdgeSource source;
    friend auto operator<=>(const SegmentPiece&, const SegmentPiece&) = default;
};

SegmentPiece piece_of(GridPoint a, GridPoint b, EdgeSource source) {
    if (b < a) return {{b, a}, {source.source, !source.reversed}};
    return {{a, b}, source};
}

struct SourceBox {
    double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x;
};

SourceBox box_of(std::span<const SourceSegment> segments) {
    SourceBox box;
    for (const SourceSegment& s : segments)
        for (const Point& p : {s.a, s.b}) {
            box.low_x = std::min(box.low_x, p.x);
            box.low_y = std::min(box.low_y, p.y);
            box.high_x = std::max(box.high_x, p.x);
            box.high_y = std::max(box.high_y, p.y);
        }
    return box;
}

/// A frame whose origin is the centre of the box, rounded to whole metres, or to whole steps when a step is
/// longer than a metre.
GridFrame frame_of(const SourceBox& box, double step) {
    const double unit = std::max(1.0, step);
    GridFrame frame;
    frame.step = step;
    frame.origin = {std::round((box.low_x + box.high_x) / 2 / unit) * unit,
                    std::round((box.low_y + box.high_y) / 2 / unit) * unit};
    const double farthest =
        std::max({std::abs(box.low_x), std::abs(box.high_x), std::abs(box.low_y), std::abs(box.high_y)});
    if (!(farthest / step < 0x1p52))
        throw std::invalid_argument("coordinates have too many digits for this grid");
    if (!(std::max(box.high_x - box.low_x, box.high_y - box.low_y) / step <
          static_cast<double>(extent_limit)))
        throw std::invalid_argument("the model is too large for this grid");
    return frame;
}

/// Number of fine-grid units per cell in the first round: the largest power of two, up to 4096, that the
/// exact arithmetic allows.
std::int64_t first_pass_units_per_cell(const SourceBox& box, double step) {
    const double cells = std::max({box.high_x - box.low_x, box.high_y - box.low_y, step}) / step + 4;
    std::int64_t units_per_cell = 2;
    while (units_per_cell < 4096 && cells * static_cast<double>(2 * units_per_cell) < 0x1p40)
        units_per_cell *= 2;
    return units_per_cell;
}

/// The segments on the fine grid of the first round. @param largest_move m, raised to the largest
/// displacement of an end.
std::vector<SegmentPiece> fine_pieces(std::span<const SourceSegment> segments, const GridFrame& frame,
                                      std::int64_t units_per_cell, double& largest_move) {
    const double scale = static_cast<double>(units_per_cell) / frame.step;
    const auto fine = [&](const Point& p) {
        const double x = (p.x - frame.origin.x) * scale, y = (p.y - frame.origin.y) * scale;
        const GridPoint unit{std::llround(x), std::llround(y)};
        const double moved =
            std::hypot(x - static_cast<double>(unit.x), y - static_cast<double>(unit.y)) / scale;
        largest_move = std::max(largest_move, moved);
        return unit;
    };
    std::vector<SegmentPiece> pieces;
    pieces.reserve(segments.size());
    for (const SourceSegment& s : segments)
        if (const GridPoint a = fine(s.a), b = fine(s.b); a != b)
            pieces.push_back(piece_of(a, b, {s.source, false}));
    return pieces;
}

/// Distinct lines, sorted, and the sources along them.
struct Lines {
    PerSegment<FineSegment> lines;
    LineSources along;
};

Lines distinct_lines(std::vector<SegmentPiece> pieces, const ThreadPool& pool) {
    parallel_sort(pool, pieces);
    Lines result;
    for (const SegmentPiece& piece : pieces) {
        if (result.lines.empty() || piece.line != result.lines.back()) {
            result.lines.push_back(piece.line);
            result.along.first.push_back(0);
        }
        result.along.sources.push_back(piece.source);
        result.along.first.back() = result.along.sources.size();
    }
    return result;
}

/// Distance of a cell's centre from a segment, in cells.
double distance(const FineSegment& s, const GridPoint& cell, std::int64_t units_per_cell) {
    const double scale = 1 / static_cast<double>(units_per_cell);
    const double ux = static_cast<double>(s.b.x - s.a.x) * scale,
                 uy = static_cast<double>(s.b.y - s.a.y) * scale;
    const double wx = static_cast<double>(cell.x * units_per_cell - s.a.x) * scale;
    const double wy = static_cast<double>(cell.y * units_per_cell - s.a.y) * scale;
    const double t = std::clamp((wx * ux + wy * uy) / (ux * ux + uy * uy), 0.0, 1.0);
    return std::hypot(wx - t * ux, wy - t * uy);
}

/// Largest distance of a chain's cell centres from its line, in cells.
double largest_move(const FineSegment& line, const SnappedChains& chains, SegmentIndex k,
                    std::int64_t units_per_cell) {
    double largest = 0;
    for (const CellIndex cell : chains.chain(k))
        largest = std::max(largest, distance(line, chains.cells[cell], units_per_cell));
    return largest;
}

/// The same over all chains.
double largest_move(SegmentSpan<const FineSegment> lines, const SnappedChains& chains,
                    std::int64_t units_per_cell, const ThreadPool& pool) {
    const auto part = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (const SegmentIndex k : indices<SegmentIndex>(begin, end))
            largest = std::max(largest, largest_move(lines[k], chains, k, units_per_cell));
        return largest;
    };
    return pool.parallel_reduce(lines.size(), 0.0, part, [](double a, double b) { return std::max(a, b); });
}

double largest_move(const SnapRoundingPass& round, const NodedEdges& network) {
    double largest = 0;
    for (const SegmentIndex k : round.edges.indices()) {
        const auto& [a, b] = network.edges[round.edges[k]];
        const FineSegment line{network.vertices[a], network.vertices[b]};
        largest = std::max(largest, largest_move(line, round.chains, k, 1));
    }
    return largest;
}

/// The cells of the outline's corners (source 0), sorted. They win when cells are merged, so that the corners
/// of the domain keep their cells.
std::vector<GridPoint> anchors_of(const std::vector<SegmentPiece>& pieces, std::int64_t units_per_cell) {
    std::vector<std::pair<SourceIndex, GridPoint>> ends;
    const auto cell = [units_per_cell](const GridPoint& p) {
        const auto nearest = [units_per_cell](std::int64_t x) {
            const std::int64_t shifted = x + units_per_cell / 2;
            return shifted >= 0 ? shifted / units_per_cell
                                : -((-shifted + units_per_cell - 1) / units_per_cell);
        };
        return GridPoint{nearest(p.x), nearest(p.y)};
    };
    for (const SegmentPiece& piece : pieces)
        if (piece.source.source == 0) {
            ends.emplace_back(piece.source.source, cell(piece.line.a));
            ends.emplace_back(piece.source.source, cell(piece.line.b));
        }
    std::sort(ends.begin(), ends.end());
    std::vector<GridPoint> anchors;
    for (const auto& [source, end] : ends) anchors.push_back(end);
    return anchors;
}

}  // namespace

std::span<const EdgeSource> NodedEdges::sources_of(EdgeIndex edge) const {
    return std::span(sources).subspan(first_source[edge], first_source[edge + 1] - first_source[edge]);
}

NodedEdges node_joints(std::span<const SourceSegment> segments, double step, const ThreadPool& pool) {
    NodedEdges result;
    if (segments.empty()) return result;
    const SourceBox box = box_of(segments);
    result.frame = frame_of(box, step);
    {
        const std::int64_t units_per_cell = first_pass_units_per_cell(box, step);
        double rounded = 0;
        std::vector<SegmentPiece> pieces = fine_pieces(segments, result.frame, units_per_cell, rounded);
        const std::vector<GridPoint> anchors = anchors_of(pieces, units_per_cell);
        const Lines lines = distinct_lines(std::move(pieces), pool);
        const SnappedChains chains = snap_round_merging_cells(lines.lines, units_per_cell, anchors, pool);
        result.largest_snap = step * largest_move(lines.lines, chains, units_per_cell, pool) + rounded;
        link_chains(chains, lines.along, result, pool);
    }
    PerEdge<char> changed;  // empty: all edges, in the first round
    for (result.rounds = 1;; ++result.rounds) {
        const SnapRoundingPass round = snap_round_edges(result.vertices, result.edges, changed, pool);
        if (round.is_fully_noded()) return result;
        result.largest_snap += step * largest_move(round, result);
        // The lines of this round are the edges of the last.
        const LineSources along{std::vector<std::int32_t>(std::move(result.first_source)),
                                std::move(result.sources)};
        changed = link_chains(chains_of_all_edges(round, result), along, result, pool);
    }
}

std::vector<EdgeIndex> improperly_noded_edges(NodeSpan<const GridPoint> vertices,
                                              EdgeSpan<const EdgeEnds> edges, EdgeSpan<const char> changed,
                                              const ThreadPool& pool) {
    return snap_round_edges(vertices, edges, changed, pool).edges;
}

}  // namespace rockslope::blockgen
