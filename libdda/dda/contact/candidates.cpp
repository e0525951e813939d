#include "dda/contact/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rockslope::dda {

namespace {

/// Buckets of edges on a uniform grid, as sorted (cell, edge) entries: no fixed extent, no empty cells
/// stored.
class EdgeGrid {
  public:
    EdgeGrid(double cell_size, const Vec2& origin) : cell_size_(cell_size), origin_(origin) {}

    /// Enters an edge into every cell within `search_radius` of it, row by row so that a long oblique edge
    /// enters few cells.
    void insert(int edge, const Vec2& first, const Vec2& second, double search_radius) {
        const std::int64_t bottom = row(std::min(first.y(), second.y()) - search_radius);
        const std::int64_t top = row(std::max(first.y(), second.y()) + search_radius);
        for (std::int64_t r = bottom; r <= top; ++r) {
            const auto [left, right] = extent_in_row(first, second, r, search_radius);
            for (std::int64_t c = column(left); c <= column(right); ++c)
                entries_.push_back({key(c, r), edge});
        }
    }
    void finish() { std::sort(entries_.begin(), entries_.end()); }

    template <class Visit>
    void visit(const Vec2& point, const Visit& found) const {
        const std::uint64_t cell = key(column(point.x()), row(point.y()));
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair{cell, -1});
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

    /// The x-range of the part of a segment that lies within `search_radius` of a grid row, widened by
    /// `search_radius`.
    std::pair<double, double> extent_in_row(const Vec2& first, const Vec2& second, std::int64_t r,
                                            double search_radius) const {
        double from = 0;
        double to = 1;
        const double dy = second.y() - first.y();
        if (dy != 0) {
            const double low = origin_.y() + static_cast<double>(r) * cell_size_ - search_radius;
            const double high = low + cell_size_ + 2 * search_radius;
            double enter = (low - first.y()) / dy;
            double leave = (high - first.y()) / dy;
            if (enter > leave) std::swap(enter, leave);
            from = std::clamp(enter, 0.0, 1.0);
            to = std::clamp(leave, 0.0, 1.0);
        }
        const double a = first.x() + from * (second.x() - first.x());
        const double b = first.x() + to * (second.x() - first.x());
        return {std::min(a, b) - search_radius, std::max(a, b) + search_radius};
    }

    double cell_size_;
    Vec2 origin_;
    std::vector<std::pair<std::uint64_t, int>> entries_;
};

}  // namespace

double median_edge_length(const Topology& topology, std::span<const Vec2> vertices) {
    std::vector<double> lengths;
    lengths.reserve(vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        lengths.push_back((vertices[static_cast<std::size_t>(topology.next[k])] - vertices[k]).norm());
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

double distance_to_segment(const Vec2& point, const Vec2& first, const Vec2& second) {
    const Vec2 along = second - first;
    const double square = along.squaredNorm();
    const double fraction = square > 0 ? std::clamp((point - first).dot(along) / square, 0.0, 1.0) : 0.0;
    return (point - first - fraction * along).norm();
}

std::vector<CornerEdge> find_candidates(const Model& model, std::span<const Vec2> vertices, double distance) {
    const Topology& topology = model.topology;
    std::vector<CornerEdge> found;
    if (vertices.empty()) return found;
    const auto end_of = [&](int edge) {
        return vertices[static_cast<std::size_t>(topology.next[static_cast<std::size_t>(edge)])];
    };
    const auto moves = [&](int block) {
        return model.motion[static_cast<std::size_t>(block)] == Motion::free;
    };
    const auto is_removed = [&](int corner) {
        const int block = topology.block_of[static_cast<std::size_t>(corner)];
        return model.motion[static_cast<std::size_t>(block)] == Motion::removed;
    };

    EdgeGrid grid(std::max(distance, median_edge_length(topology, vertices)), vertices[0]);
    for (int edge = 0; edge < topology.corner_count(); ++edge) {
        if (is_removed(edge)) continue;
        grid.insert(edge, vertices[static_cast<std::size_t>(edge)], end_of(edge), distance);
    }
    grid.finish();
    for (int corner = 0; corner < topology.corner_count(); ++corner) {
        if (is_removed(corner)) continue;
        const auto k = static_cast<std::size_t>(corner);
        const Vec2& vertex = vertices[k];
        const Vec2 arriving = vertex - vertices[static_cast<std::size_t>(topology.previous[k])];
        const Vec2 leaving = end_of(corner) - vertex;
        // The margin keeps a straight corner, which turns by rounding only.
        if (cross(arriving, leaving) < -1e-3 * arriving.norm() * leaving.norm()) continue;
        const int block = topology.block_of[k];
        grid.visit(vertex, [&](int edge) {
            const auto e = static_cast<std::size_t>(edge);
            const int other = topology.block_of[e];
            if (other == block || !(moves(block) || moves(other))) return;
            if (distance_to_segment(vertex, vertices[e], end_of(edge)) <= distance)
                found.push_back({corner, edge});
        });
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace rockslope::dda
