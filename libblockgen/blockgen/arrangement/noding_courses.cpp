#include "blockgen/arrangement/noding_courses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "common/base/text.hpp"
#include "common/geometry/segment.hpp"

namespace rockslope::blockgen {

namespace {

Point cells_of(const Point& p, const GridFrame& frame) {
    return {(p.x - frame.origin.x) / frame.step, (p.y - frame.origin.y) / frame.step};
}

Point real_point(const GridPoint& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

double distance(const Point& p, const Point& q) {
    return std::hypot(p.x - q.x, p.y - q.y);
}

/// Walks the courses of segments along the edges of their sources.
class CourseWalk {
  public:
    CourseWalk(const NodedEdges& noded, const NodingBounds& bounds)
        : noded_(noded),
          bounds_(bounds),
          nodes_(noded.vertices),
          links_(course_links(noded)),
          is_walked_(links_.size(), 0),
          last_walk_(noded.vertices.size(), -1) {}

    /// Whether edges of the source lead from one end of a segment to the other, within the bound of it.
    bool walk(const SourceSegment& segment) {
        const Point a = cells_of(segment.a, noded_.frame), b = cells_of(segment.b, noded_.frame);
        ++walk_;
        std::vector<NodeIndex> reached;
        const auto reach = [&](NodeIndex node) {
            if (last_walk_[node] == walk_) return;
            last_walk_[node] = walk_;
            reached.push_back(node);
        };
        for (const NodeIndex node : nodes_.within(a, bounds_.end))
            if (distance(place(node), a) <= bounds_.end) reach(node);
        bool arrives = false;
        for (std::size_t next = 0; next < reached.size();) {
            const NodeIndex node = reached[next++];
            bool is_of_source = false;
            const auto first =
                std::lower_bound(links_.begin(), links_.end(), CourseLink{segment.source, node, 0});
            for (auto link = first;
                 link != links_.end() && link->source == segment.source && link->from == node; ++link) {
                is_of_source = true;
                if (distance_to_segment(place(link->to), a, b) > bounds_.course ||
                    distance_to_segment(place(node), a, b) > bounds_.course)
                    continue;
                is_walked_[link - links_.begin()] = 1;
                reach(link->to);
                arrives = arrives || distance(place(link->to), b) <= bounds_.end;
            }
            arrives = arrives || (is_of_source && distance(place(node), b) <= bounds_.end);
        }
        return arrives;
    }

    /// @throws std::logic_error when an edge is on no course of one of its sources.
    void require_all_walked() const {
        const auto missed = std::find(is_walked_.begin(), is_walked_.end(), 0);
        if (missed == is_walked_.end()) return;
        const CourseLink& link = links_[missed - is_walked_.begin()];
        const Point p = noded_.frame.position(noded_.vertices[link.from]);
        throw std::logic_error("noding: the edge at (" + shortest_text(p.x) + ", " + shortest_text(p.y) +
                               ") runs along no segment of its source " +
                               std::to_string(link.source.value()));
    }

  private:
    Point place(NodeIndex node) const { return real_point(noded_.vertices[node]); }

    const NodedEdges& noded_;
    const NodingBounds& bounds_;
    NodesByPlace nodes_;
    std::vector<CourseLink> links_;
    std::vector<char> is_walked_;
    PerNode<std::int32_t> last_walk_;  ///< number of the walk that reached a node last
    std::int32_t walk_ = -1;
};

}  // namespace

NodingBounds noding_bounds(const NodedEdges& noded, double extent) {
    // Distances are computed in doubles from coordinates of at most 2^38 cells.
    constexpr double slack = 1e-3;
    // Cells that touch are merged: an end lies in its own cell, the centre of the other is 1.5 cells away.
    constexpr double end = 1.5 * std::numbers::sqrt2;
    // The fine grid has 4096 units to a cell, or as many as coordinates below 2^40 allow.
    const double rounding = 0x1p-12 + 0x1p-40 * (extent / noded.frame.step + 4);
    return {noded.largest_snap / noded.frame.step + slack, end + rounding + slack, rounding};
}

std::vector<NodeIndex> NodesByPlace::within(const Point& p, double reach) const {
    // Beyond this reach all nodes between two columns are looked at, not those of each column.
    constexpr double most_columns = 64;
    std::vector<NodeIndex> found;
    const auto ceil = [](double x) { return static_cast<std::int64_t>(std::ceil(x)); };
    const std::int64_t low_x = ceil(p.x - reach), low_y = ceil(p.y - reach);
    const auto at = [&](std::int64_t x, std::int64_t y) {
        return std::lower_bound(nodes_.begin(), nodes_.end(), GridPoint{x, y});
    };
    const auto add = [&](auto node) {
        if (std::abs(static_cast<double>(node->y) - p.y) <= reach)
            found.push_back(static_cast<std::int32_t>(node - nodes_.begin()));
    };
    if (2 * reach > most_columns) {
        for (auto node = at(low_x, low_y);
             node != nodes_.end() && static_cast<double>(node->x) <= p.x + reach; ++node)
            add(node);
        return found;
    }
    for (std::int64_t x = low_x; static_cast<double>(x) <= p.x + reach; ++x)
        for (auto node = at(x, low_y);
             node != nodes_.end() && node->x == x && static_cast<double>(node->y) <= p.y + reach; ++node)
            add(node);
    return found;
}

std::vector<CourseLink> course_links(const NodedEdges& noded) {
    std::vector<CourseLink> links;
    links.reserve(noded.sources.size());
    for (const EdgeIndex e : noded.edges.indices())
        for (const EdgeSource& s : noded.sources_of(e)) {
            const auto& [a, b] = noded.edges[e];
            links.push_back(s.reversed ? CourseLink{s.source, b, a} : CourseLink{s.source, a, b});
        }
    std::sort(links.begin(), links.end());
    return links;
}

std::vector<char> prove_courses(std::span<const SourceSegment> segments, const NodedEdges& noded,
                                const NodingBounds& bounds) {
    CourseWalk courses(noded, bounds);
    std::vector<char> is_collapsed(segments.size(), 0);
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const SourceSegment& s = segments[k];
        if (s.a == s.b || courses.walk(s)) continue;
        if (distance(s.a, s.b) > 2 * bounds.end * noded.frame.step)
            throw std::logic_error("noding: the segment from (" + shortest_text(s.a.x) + ", " +
                                   shortest_text(s.a.y) + ") to (" + shortest_text(s.b.x) + ", " +
                                   shortest_text(s.b.y) + ") has no course within " +
                                   shortest_text(noded.largest_snap) + " m");
        is_collapsed[k] = 1;
    }
    courses.require_all_walked();
    return is_collapsed;
}

}  // namespace rockslope::blockgen
