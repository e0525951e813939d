#include "blockgen/mesh/find_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "blockgen/mesh/measures.hpp"
#include "common/geometry/segment.hpp"

namespace rockslope::blockgen {

namespace {

struct Edge {
    Point a, b;
};

struct Box {
    double x_min = std::numeric_limits<double>::infinity(), x_max = -x_min;
    double y_min = x_min, y_max = -x_min;

    void add(const Point& p) {
        x_min = std::min(x_min, p.x);
        x_max = std::max(x_max, p.x);
        y_min = std::min(y_min, p.y);
        y_max = std::max(y_max, p.y);
    }
    bool meets(const Box& other) const {
        return x_min <= other.x_max && other.x_min <= x_max && y_min <= other.y_max && other.y_min <= y_max;
    }
    bool holds(const Point& p) const { return x_min <= p.x && p.x <= x_max && y_min <= p.y && p.y <= y_max; }
};

Box box_of(const Edge& edge) {
    Box box;
    box.add(edge.a);
    box.add(edge.b);
    return box;
}

struct Outline {
    std::vector<Edge> edges;
    Box box;
    double size = 0;  ///< m, square root of the area
    Point inner;      ///< a point inside, away from the boundary where the block is convex
    double inner_depth = 0;
};

/// Distance of a point inside a block from its boundary, m; zero for a point outside.
double depth_inside(const Outline& block, const Point& p) {
    if (!block.box.holds(p)) return 0;
    bool inside = false;
    for (const Edge& e : block.edges) {
        if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
        if (p.x < e.a.x + (p.y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x)) inside = !inside;
    }
    if (!inside) return 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Edge& e : block.edges) nearest = std::min(nearest, distance_to_segment(p, e.a, e.b));
    return nearest;
}

/// Goes from the middle of an edge into the block, half as far each time.
void find_inner_point(Outline& block) {
    const Edge& e = block.edges.front();
    const double length = std::hypot(e.b.x - e.a.x, e.b.y - e.a.y);
    constexpr int halvings = 9;
    double step = block.size;
    for (int k = 0; k < halvings; ++k) {
        step /= 2;
        const Point p{(e.a.x + e.b.x) / 2 - step * (e.b.y - e.a.y) / length,
                      (e.a.y + e.b.y) / 2 + step * (e.b.x - e.a.x) / length};
        const double found = depth_inside(block, p);
        if (found > block.inner_depth) block.inner = p, block.inner_depth = found;
    }
}

Outline outline_of(const BlockMesh& mesh, BlockIndex block) {
    Outline outline;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        const Ring ring = ring_points(mesh, block, r);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            outline.edges.push_back({ring[k], ring[(k + 1) % ring.size()]});
            outline.box.add(ring[k]);
        }
    }
    outline.size = std::sqrt(std::max(block_area(mesh, block), 0.0));
    find_inner_point(outline);
    return outline;
}

/// The place of an edge, 0 to 1 from its beginning, where it meets the line of another one.
double crossing(const Edge& edge, const Edge& line) {
    const double lx = line.b.x - line.a.x, ly = line.b.y - line.a.y;
    const double from = (edge.a.x - line.a.x) * ly - (edge.a.y - line.a.y) * lx;
    const double to = (edge.b.x - line.a.x) * ly - (edge.b.y - line.a.y) * lx;
    return from == to ? 0 : from / (from - to);
}

/// The deepest of the middles of the parts into which a block's boundary divides an edge. @param near edges
/// of the block, all of those that meet the edge among them.
Overlap deepest_part(const Edge& edge, const Outline& block, const std::vector<Edge>& near,
                     std::vector<double>& ends) {
    ends.assign({0, 1});
    const Box box = box_of(edge);
    const double ex = edge.b.x - edge.a.x, ey = edge.b.y - edge.a.y;
    const double square = ex * ex + ey * ey;
    for (const Edge& other : near) {
        if (!box.meets(box_of(other))) continue;
        ends.push_back(crossing(edge, other));
        if (square > 0) ends.push_back(((other.a.x - edge.a.x) * ex + (other.a.y - edge.a.y) * ey) / square);
    }
    std::erase_if(ends, [](double t) { return !(t >= 0 && t <= 1); });
    std::sort(ends.begin(), ends.end());
    Overlap deepest{};
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double t = (ends[k - 1] + ends[k]) / 2;
        const Point middle{edge.a.x + t * ex, edge.a.y + t * ey};
        const double depth = depth_inside(block, middle);
        if (depth > deepest.depth) deepest = {0, 0, middle, depth};
    }
    return deepest;
}

/// The edges of a block that meet a box.
void find_near(const Outline& block, const Box& box, std::vector<Edge>& near) {
    near.clear();
    for (const Edge& edge : block.edges)
        if (box_of(edge).meets(box)) near.push_back(edge);
}

/// Finds overlaps of two blocks. Keeps its work space.
class PairCheck {
  public:
    std::optional<Overlap> overlap_of(const Outline& a, const Outline& b) {
        const double least = overlap_share * std::min(a.size, b.size);
        deepest_ = {};
        find_near(a, b.box, near_a_);
        find_near(b, a.box, near_b_);
        consider_edges(near_a_, b, near_b_);
        consider_edges(near_b_, a, near_a_);
        consider_inner_point(a, b);
        consider_inner_point(b, a);
        if (!(deepest_.depth > least)) return std::nullopt;
        return deepest_;
    }

  private:
    void consider(const Overlap& found) {
        if (found.depth > deepest_.depth) deepest_ = found;
    }
    void consider_edges(const std::vector<Edge>& edges, const Outline& other, const std::vector<Edge>& near) {
        if (near.empty()) return;  // the boundaries do not meet
        for (const Edge& edge : edges) consider(deepest_part(edge, other, near, ends_));
    }
    void consider_inner_point(const Outline& one, const Outline& other) {
        if (!other.box.holds(one.inner)) return;
        consider({0, 0, one.inner, std::min(one.inner_depth, depth_inside(other, one.inner))});
    }

    Overlap deepest_{};
    std::vector<Edge> near_a_, near_b_;
    std::vector<double> ends_;
};

/// The blocks of each cell of a grid, by their boxes; those of many cells apart.
class BoxGrid {
  public:
    explicit BoxGrid(const std::vector<Outline>& blocks) {
        Box all;
        std::vector<double> sizes;
        for (const Outline& block : blocks) {
            all.add({block.box.x_min, block.box.y_min});
            all.add({block.box.x_max, block.box.y_max});
            sizes.push_back(std::max(block.box.x_max - block.box.x_min, block.box.y_max - block.box.y_min));
        }
        std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2),
                         sizes.end());
        const double width = all.x_max - all.x_min, height = all.y_max - all.y_min;
        const double most = 4 * static_cast<double>(blocks.size()) + 16;
        cell_ = std::max({sizes[sizes.size() / 2], std::sqrt(width * height / most), width / most,
                          height / most, std::numeric_limits<double>::min()});
        origin_ = {all.x_min, all.y_min};
        columns_ = static_cast<std::size_t>(width / cell_) + 1;
        cells_.resize(columns_ * (static_cast<std::size_t>(height / cell_) + 1));
        for (std::size_t k = 0; k < blocks.size(); ++k) add(k, blocks[k].box);
    }

    /// The blocks before block `k` whose boxes may meet its box, ascending.
    std::vector<std::size_t> before(std::size_t k, const Box& box) const {
        std::vector<std::size_t> found = large_;
        if (is_large(box)) {
            found.resize(k);
            for (std::size_t i = 0; i < k; ++i) found[i] = i;
        } else {
            for_cells(box, [&](std::size_t cell) {
                found.insert(found.end(), cells_[cell].begin(), cells_[cell].end());
            });
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        found.erase(std::lower_bound(found.begin(), found.end(), k), found.end());
        return found;
    }

  private:
    static constexpr double large_extent = 8;  // cells

    bool is_large(const Box& box) const {
        return box.x_max - box.x_min > large_extent * cell_ || box.y_max - box.y_min > large_extent * cell_;
    }
    template <class Visit>
    void for_cells(const Box& box, const Visit& visit) const {
        const auto index = [&](double from) { return static_cast<std::size_t>(from / cell_); };
        for (std::size_t y = index(box.y_min - origin_.y); y <= index(box.y_max - origin_.y); ++y)
            for (std::size_t x = index(box.x_min - origin_.x); x <= index(box.x_max - origin_.x); ++x)
                visit(y * columns_ + x);
    }
    void add(std::size_t k, const Box& box) {
        if (is_large(box))
            large_.push_back(k);
        else
            for_cells(box, [&](std::size_t cell) { cells_[cell].push_back(k); });
    }

    double cell_ = 1;  ///< m
    Point origin_;
    std::size_t columns_ = 1;
    std::vector<std::vector<std::size_t>> cells_;
    std::vector<std::size_t> large_;
};

}  // namespace

std::optional<Overlap> find_overlap(const BlockMesh& mesh) {
    if (mesh.block_count() < 2) return std::nullopt;
    std::vector<Outline> blocks;
    for (const BlockIndex block : mesh.blocks()) blocks.push_back(outline_of(mesh, block));
    const BoxGrid grid(blocks);
    PairCheck check;
    for (std::size_t k = 1; k < blocks.size(); ++k) {
        for (const std::size_t other : grid.before(k, blocks[k].box)) {
            if (!blocks[k].box.meets(blocks[other].box)) continue;
            std::optional<Overlap> found = check.overlap_of(blocks[other], blocks[k]);
            if (!found) continue;
            found->first = static_cast<std::int32_t>(other);
            found->second = static_cast<std::int32_t>(k);
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace rockslope::blockgen
