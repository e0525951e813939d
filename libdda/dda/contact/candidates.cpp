#include "dda/contact/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace rockslope::dda {

namespace {

/// Edges on a uniform grid, stored as sorted (cell, edge) entries. The grid has no fixed extent and stores no
/// empty cells.
class EdgeGrid {
  public:
    EdgeGrid(double cell_size, const Vec2& origin) : cell_size_(cell_size), origin_(origin) {}

    /// Enters an edge into every cell within `distance` of it. Each grid row gets only the cells beside the
    /// edge's part in it, so that a long oblique edge takes few cells.
    void insert(EdgeIndex edge, const Vec2& first, const Vec2& second, double distance) {
        const std::int64_t bottom = row(std::min(first.y(), second.y()) - distance);
        const std::int64_t top = row(std::max(first.y(), second.y()) + distance);
        for (std::int64_t r = bottom; r <= top; ++r) {
            const auto [left, right] = extent_in_row(first, second, r, distance);
            for (std::int64_t c = column(left); c <= column(right); ++c)
                entries_.push_back({key(c, r), edge});
        }
    }
    void finish() { std::sort(entries_.begin(), entries_.end()); }

    /// Calls found(edge) for every edge entered into the cell of the point.
    template <class Visit>
    void visit(const Vec2& point, const Visit& found) const {
        const std::uint64_t cell = key(column(point.x()), row(point.y()));
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair{cell, EdgeIndex::none()});
        for (; entry != entries_.end() && entry->first == cell; ++entry) found(entry->second);
    }

  private:
    std::int64_t column(double x) const {
        return static_cast<std::int64_t>(std::floor((x - origin_.x()) / cell_size_));
    }
    std::int64_t row(double y) const {
        return static_cast<std::int64_t>(std::floor((y - origin_.y()) / cell_size_));
    }
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        return (static_cast<std::uint64_t>(row) << 32) ^ (static_cast<std::uint64_t>(column) & 0xffffffffu);
    }

    /// The x-range of the segment's part within `distance` of a grid row, widened by `distance`.
    std::pair<double, double> extent_in_row(const Vec2& first, const Vec2& second, std::int64_t r,
                                            double distance) const {
        double from = 0;
        double to = 1;
        const double dy = second.y() - first.y();
        if (dy != 0) {
            const double low = origin_.y() + static_cast<double>(r) * cell_size_ - distance;
            const double high = low + cell_size_ + 2 * distance;
            double enter = (low - first.y()) / dy;
            double leave = (high - first.y()) / dy;
            if (enter > leave) std::swap(enter, leave);
            from = std::clamp(enter, 0.0, 1.0);
            to = std::clamp(leave, 0.0, 1.0);
        }
        const double a = first.x() + from * (second.x() - first.x());
        const double b = first.x() + to * (second.x() - first.x());
        return {std::min(a, b) - distance, std::max(a, b) + distance};
    }

    double cell_size_;
    Vec2 origin_;
    std::vector<std::pair<std::uint64_t, EdgeIndex>> entries_;
};

}  // namespace

double median_edge_length(const Topology& topology, CornerSpan<const Vec2> vertices) {
    std::vector<double> lengths;
    lengths.reserve(vertices.size());
    for (const CornerIndex k : vertices.indices())
        lengths.push_back((vertices[topology.next[k]] - vertices[k]).norm());
    const auto middle = std::next(lengths.begin(), lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

double distance_to_segment(const Vec2& point, const Vec2& first, const Vec2& second) {
    const Vec2 along = second - first;
    const double square = along.squaredNorm();
    const double fraction = square > 0 ? std::clamp((point - first).dot(along) / square, 0.0, 1.0) : 0.0;
    return (point - first - fraction * along).norm();
}

bool is_within(double distance, const Vec2& point, const Vec2& first, const Vec2& second) {
    // Most points are not even near the box around the segment.
    const Vec2 low = first.cwiseMin(second), high = first.cwiseMax(second);
    if ((low - point).maxCoeff() > distance || (point - high).maxCoeff() > distance) return false;
    return distance_to_segment(point, first, second) <= distance;
}

std::vector<CornerEdge> find_candidates(const Model& model, CornerSpan<const Vec2> vertices,
                                        double distance) {
    const Topology& topology = model.topology;
    std::vector<CornerEdge> found;
    if (vertices.empty()) return found;
    const auto start_point = [&](EdgeIndex edge) -> const Vec2& { return vertices[start_of(edge)]; };
    const auto end_point = [&](EdgeIndex edge) -> const Vec2& { return vertices[topology.end_of(edge)]; };
    const auto moves = [&](BlockIndex block) { return model.motion[block] == Motion::free; };
    const auto is_removed = [&](CornerIndex corner) {
        return model.motion[topology.block_of[corner]] == Motion::removed;
    };

    EdgeGrid grid(std::max(distance, median_edge_length(topology, vertices)), vertices[0]);
    for (const EdgeIndex edge : topology.edges()) {
        if (is_removed(start_of(edge))) continue;
        grid.insert(edge, start_point(edge), end_point(edge), distance);
    }
    grid.finish();
    for (const CornerIndex corner : topology.corners()) {
        if (is_removed(corner)) continue;
        const Vec2& vertex = vertices[corner];
        const Vec2 arriving = vertex - vertices[topology.previous[corner]];
        const Vec2 leaving = vertices[topology.next[corner]] - vertex;
        // Skip reflex corners. The margin keeps a straight corner whose angle is off by rounding.
        if (cross(arriving, leaving) < -1e-3 * arriving.norm() * leaving.norm()) continue;
        const BlockIndex block = topology.block_of[corner];
        grid.visit(vertex, [&](EdgeIndex edge) {
            const BlockIndex other = topology.block_of_edge(edge);
            if (other == block || !(moves(block) || moves(other))) return;
            if (is_within(distance, vertex, start_point(edge), end_point(edge)))
                found.push_back({corner, edge});
        });
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace rockslope::dda
