#include "blockgen/node_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "blockgen/snap_round.hpp"

namespace blockgen {

namespace {

constexpr std::int64_t extent_limit = std::int64_t{1} << 38;

/// A source along a piece between two grid points, the first before the second.
struct Piece {
    FineSegment line;
    EdgeSource source;
    friend auto operator<=>(const Piece&, const Piece&) = default;
};

Piece piece_of(GridPoint a, GridPoint b, EdgeSource source) {
    if (b < a) return {{b, a}, {source.source, !source.reversed}};
    return {{a, b}, source};
}

struct Box {
    double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x;
};

Box box_of(std::span<const SourceSegment> segments) {
    Box box;
    for (const SourceSegment& s : segments)
        for (const Point& p : {s.a, s.b}) {
            box.low_x = std::min(box.low_x, p.x);
            box.low_y = std::min(box.low_y, p.y);
            box.high_x = std::max(box.high_x, p.x);
            box.high_y = std::max(box.high_y, p.y);
        }
    return box;
}

/// A frame whose origin is the box's middle rounded to whole metres, or to whole steps where those are
/// longer.
GridFrame frame_of(const Box& box, double step) {
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

/// How many units of the first round's grid make one cell: as fine as the exact arithmetic allows, at most
/// 4096.
std::int64_t first_fineness(const Box& box, double step) {
    const double cells = std::max({box.high_x - box.low_x, box.high_y - box.low_y, step}) / step + 4;
    std::int64_t fineness = 2;
    while (fineness < 4096 && cells * static_cast<double>(2 * fineness) < 0x1p40) fineness *= 2;
    return fineness;
}

std::vector<Piece> fine_pieces(std::span<const SourceSegment> segments, const GridFrame& frame,
                               std::int64_t fineness) {
    const double scale = static_cast<double>(fineness) / frame.step;
    const auto fine = [&](const Point& p) {
        return GridPoint{std::llround((p.x - frame.origin.x) * scale),
                         std::llround((p.y - frame.origin.y) * scale)};
    };
    std::vector<Piece> pieces;
    pieces.reserve(segments.size());
    for (const SourceSegment& s : segments)
        if (const GridPoint a = fine(s.a), b = fine(s.b); a != b)
            pieces.push_back(piece_of(a, b, {s.source, false}));
    return pieces;
}

/// The distinct lines of sorted pieces; line k has the pieces [first[k], first[k + 1]).
struct Lines {
    std::vector<FineSegment> lines;
    std::vector<std::size_t> first = {0};
};

Lines distinct_lines(std::vector<Piece>& pieces) {
    std::sort(pieces.begin(), pieces.end());
    Lines result;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (k > 0 && pieces[k].line == pieces[k - 1].line) {
            result.first.back() = k + 1;
        } else {
            result.lines.push_back(pieces[k].line);
            result.first.push_back(k + 1);
        }
    }
    return result;
}

/// Distance of a cell's centre from a segment, in cells.
double distance(const FineSegment& s, const GridPoint& cell, std::int64_t fineness) {
    const double scale = 1 / static_cast<double>(fineness);
    const double ux = static_cast<double>(s.b.x - s.a.x) * scale,
                 uy = static_cast<double>(s.b.y - s.a.y) * scale;
    const double wx = static_cast<double>(cell.x * fineness - s.a.x) * scale;
    const double wy = static_cast<double>(cell.y * fineness - s.a.y) * scale;
    const double t = std::clamp((wx * ux + wy * uy) / (ux * ux + uy * uy), 0.0, 1.0);
    return std::hypot(wx - t * ux, wy - t * uy);
}

double largest_move(const Lines& lines, const SnappedChains& chains, std::int64_t fineness) {
    double largest = 0;
    for (std::size_t k = 0; k < lines.lines.size(); ++k)
        for (const GridPoint& cell : chains.chain(k))
            largest = std::max(largest, distance(lines.lines[k], cell, fineness));
    return largest;
}

/// The pieces that the chains make, in cells; those that shrank to a point are gone.
std::vector<Piece> chain_pieces(const std::vector<Piece>& pieces, const Lines& lines,
                                const SnappedChains& chains) {
    std::vector<Piece> result;
    for (std::size_t k = 0; k < lines.lines.size(); ++k) {
        const auto chain = chains.chain(k);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            for (std::size_t p = lines.first[k]; p < lines.first[k + 1]; ++p)
                result.push_back(piece_of(chain[i], chain[i + 1], pieces[p].source));
    }
    return result;
}

std::vector<FineSegment> doubled(std::span<const FineSegment> lines) {
    std::vector<FineSegment> result;
    result.reserve(lines.size());
    for (const FineSegment& s : lines) result.push_back({{2 * s.a.x, 2 * s.a.y}, {2 * s.b.x, 2 * s.b.y}});
    return result;
}

bool is_clean(const SnappedChains& chains) {
    return chains.cells.size() == 2 * (chains.first.size() - 1);
}

/// Ends of closed outlines come first, so that their corners stay where they are; a source of lower number
/// first.
std::vector<GridPoint> anchors_of(const std::vector<Piece>& pieces, std::int64_t fineness) {
    std::vector<std::pair<std::int32_t, GridPoint>> ends;
    const auto cell = [fineness](const GridPoint& p) {
        const auto nearest = [fineness](std::int64_t x) {
            const std::int64_t shifted = x + fineness / 2;
            return shifted >= 0 ? shifted / fineness : -((-shifted + fineness - 1) / fineness);
        };
        return GridPoint{nearest(p.x), nearest(p.y)};
    };
    for (const Piece& piece : pieces)
        if (piece.source.source == 0) {
            ends.emplace_back(piece.source.source, cell(piece.line.a));
            ends.emplace_back(piece.source.source, cell(piece.line.b));
        }
    std::sort(ends.begin(), ends.end());
    std::vector<GridPoint> anchors;
    for (const auto& [source, end] : ends) anchors.push_back(end);
    return anchors;
}

void fill_edges(NodedEdges& result, const std::vector<Piece>& pieces, const Lines& lines) {
    for (const FineSegment& s : lines.lines) {
        result.vertices.push_back(s.a);
        result.vertices.push_back(s.b);
    }
    std::sort(result.vertices.begin(), result.vertices.end());
    result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end()), result.vertices.end());
    // Lines come sorted, and their second ends lie not far after the first: steps that double from there are
    // faster than a search through all.
    const auto index_from = [&](std::size_t start, const GridPoint& p) {
        std::size_t step = 1;
        while (start + step < result.vertices.size() && result.vertices[start + step] < p) step *= 2;
        const auto first = result.vertices.begin() + static_cast<std::ptrdiff_t>(start + step / 2);
        const auto last = result.vertices.begin() +
                          static_cast<std::ptrdiff_t>(std::min(start + step + 1, result.vertices.size()));
        return static_cast<std::size_t>(std::lower_bound(first, last, p) - result.vertices.begin());
    };
    result.edges.reserve(lines.lines.size());
    result.first_source.reserve(lines.lines.size() + 1);
    result.sources.reserve(pieces.size());
    std::size_t first = 0;
    for (std::size_t k = 0; k < lines.lines.size(); ++k) {
        while (result.vertices[first] != lines.lines[k].a) ++first;
        result.edges.emplace_back(static_cast<std::int32_t>(first),
                                  static_cast<std::int32_t>(index_from(first, lines.lines[k].b)));
        for (std::size_t p = lines.first[k]; p < lines.first[k + 1]; ++p)
            result.sources.push_back(pieces[p].source);
        result.first_source.push_back(static_cast<std::int32_t>(result.sources.size()));
    }
}

}  // namespace

std::span<const EdgeSource> NodedEdges::sources_of(std::size_t edge) const {
    return std::span(sources).subspan(static_cast<std::size_t>(first_source[edge]),
                                      static_cast<std::size_t>(first_source[edge + 1] - first_source[edge]));
}

NodedEdges node_joints(std::span<const SourceSegment> segments, double step) {
    NodedEdges result;
    if (segments.empty()) return result;
    const Box box = box_of(segments);
    result.frame = frame_of(box, step);

    std::int64_t fineness = first_fineness(box, step);
    std::vector<Piece> pieces = fine_pieces(segments, result.frame, fineness);
    Lines lines = distinct_lines(pieces);
    const std::vector<GridPoint> anchors = anchors_of(pieces, fineness);
    SnappedChains chains = snap_round(lines.lines, fineness, true, anchors);
    while (true) {
        ++result.rounds;
        result.largest_snap += step * largest_move(lines, chains, fineness);
        pieces = chain_pieces(pieces, lines, chains);
        const Lines cells = distinct_lines(pieces);
        const std::vector<FineSegment> next = doubled(cells.lines);
        chains = snap_round(next, 2, false);
        lines = {next, cells.first};
        fineness = 2;
        if (is_clean(chains)) {
            fill_edges(result, pieces, cells);
            return result;
        }
    }
}

std::vector<std::size_t> unclean_edges(std::span<const GridPoint> vertices,
                                       std::span<const std::pair<std::int32_t, std::int32_t>> edges) {
    std::vector<FineSegment> lines;
    lines.reserve(edges.size());
    for (const auto& [a, b] : edges)
        lines.push_back({vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)]});
    const SnappedChains chains = snap_round(doubled(lines), 2, false);
    std::vector<std::size_t> unclean;
    for (std::size_t k = 0; k < lines.size(); ++k)
        if (chains.chain(k).size() != 2) unclean.push_back(k);
    return unclean;
}

}  // namespace blockgen
