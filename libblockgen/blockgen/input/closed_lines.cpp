#include "blockgen/input/closed_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "common/base/text.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

namespace {

/// An end of a line: its first point or its last.
struct LineEnd {
    std::size_t line = 0;
    bool last = false;
};

/// The ends of lines by their places.
class LineEnds {
  public:
    explicit LineEnds(const std::vector<Ring>& lines) : lines_(lines) {
        Ring all;
        for (const Ring& line : lines) all.insert(all.end(), {line.front(), line.back()});
        const auto [low, high] = Bounds::of(all);
        tolerance_ =
            std::max(1e-6 * std::max(high.x - low.x, high.y - low.y), std::numeric_limits<double>::min());
        origin_ = low;
        for (std::size_t k = 0; k < lines.size(); ++k)
            for (const bool last : {false, true}) ends_[cell(point({k, last}))].push_back({k, last});
    }

    const Point& point(const LineEnd& end) const {
        return end.last ? lines_[end.line].back() : lines_[end.line].front();
    }

    /// The ends at the place of another one, without itself.
    std::vector<LineEnd> at(const LineEnd& end) const {
        std::vector<LineEnd> found;
        const Point& p = point(end);
        const auto [column, row] = cell(p);
        for (std::int64_t c = column - 1; c <= column + 1; ++c)
            for (std::int64_t r = row - 1; r <= row + 1; ++r) {
                const auto here = ends_.find({c, r});
                if (here == ends_.end()) continue;
                for (const LineEnd& other : here->second) {
                    const bool same = other.line == end.line && other.last == end.last;
                    const Point& q = point(other);
                    if (!same && std::hypot(q.x - p.x, q.y - p.y) <= tolerance_) found.push_back(other);
                }
            }
        return found;
    }

  private:
    using Cell = std::pair<std::int64_t, std::int64_t>;
    Cell cell(const Point& p) const {
        return {std::llround((p.x - origin_.x) / tolerance_), std::llround((p.y - origin_.y) / tolerance_)};
    }

    const std::vector<Ring>& lines_;
    double tolerance_ = 0;
    Point origin_;
    std::map<Cell, std::vector<LineEnd>> ends_;
};

bool is_closed(const Ring& line) {
    return line.size() > 1 && line.front() == line.back();
}

/// The only end that continues a line. @throws InputError
LineEnd continuation(const LineEnds& ends, const LineEnd& end, const SourceLocation& place) {
    const std::vector<LineEnd> others = ends.at(end);
    if (others.size() == 1) return others[0];
    const Point& p = ends.point(end);
    const std::string where = " at (" + shortest_text(p.x) + ", " + shortest_text(p.y) + ")";
    throw InputError(place,
                     others.empty() ? "a line is not closed: it ends" + where + ", where no other ends"
                                    : std::to_string(others.size() + 1) + " lines end" + where,
                     "polygons, closed lines, or lines that form closed chains");
}

/// Whether a ring lies inside another one that it does not cross.
bool is_inside(const Ring& ring, const Ring& other) {
    for (const Point& p : ring)
        if (const int side = side_of_ring(other, p); side != 0) return side > 0;
    return false;
}

}  // namespace

std::vector<Ring> closed_lines(std::vector<Ring> lines, const SourceLocation& place) {
    std::vector<Ring> closed, open;
    for (Ring& line : lines) (is_closed(line) ? closed : open).push_back(std::move(line));
    if (open.empty()) return closed;
    const LineEnds ends(open);
    std::vector<char> used(open.size(), 0);
    for (std::size_t k = 0; k < open.size(); ++k) {
        if (used[k]) continue;
        Ring chain;
        LineEnd start{k, false};
        while (!used[start.line]) {
            used[start.line] = 1;
            Ring next = open[start.line];
            if (start.last) std::reverse(next.begin(), next.end());
            chain.insert(chain.end(), next.begin(), next.end() - 1);
            start = continuation(ends, {start.line, !start.last}, place);
        }
        chain.push_back(chain.front());
        closed.push_back(std::move(chain));
    }
    return closed;
}

std::vector<std::vector<Ring>> nested_polygons(std::vector<Ring> rings) {
    std::vector<std::size_t> depth(rings.size(), 0);
    std::vector<std::optional<std::size_t>> around(rings.size());  // the smallest ring round each
    const auto area = [&](std::size_t k) { return std::abs(twice_signed_area(rings[k])); };
    for (std::size_t k = 0; k < rings.size(); ++k)
        for (std::size_t other = 0; other < rings.size(); ++other) {
            if (k == other || area(other) <= area(k) || !is_inside(rings[k], rings[other])) continue;
            ++depth[k];
            if (!around[k] || area(other) < area(*around[k])) around[k] = other;
        }
    std::vector<std::vector<Ring>> polygons;
    std::vector<std::size_t> polygon_of(rings.size(), 0);
    for (std::size_t k = 0; k < rings.size(); ++k)
        if (depth[k] % 2 == 0) {
            polygon_of[k] = polygons.size();
            polygons.push_back({rings[k]});
        }
    for (std::size_t k = 0; k < rings.size(); ++k)
        if (depth[k] % 2 == 1) polygons[polygon_of[*around[k]]].push_back(rings[k]);
    return polygons;
}

}  // namespace rockslope::blockgen
