#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "dda/model/model.hpp"

namespace rockslope::scene {

/// The overlap of two blocks, computed from their polygons without contacts.
struct Overlap {
    int first = 0;
    int second = 0;
    double area = 0;  ///< m2
};

namespace detail {

struct Side {
    dda::Vec2 left;
    dda::Vec2 right;
    double sign = 0;  ///< +1 where the rock is below the side
};

inline dda::Vec2 at(std::span<const dda::Vec2> vertices, dda::CornerIndex corner) {
    return vertices[corner];
}

inline std::vector<Side> sides_of(const dda::Topology& topology, std::span<const dda::Vec2> vertices,
                                  int block) {
    std::vector<Side> sides;
    for (const dda::CornerIndex k : topology.corners_of(block)) {
        const dda::Vec2 from = at(vertices, k);
        const dda::Vec2 to = at(vertices, topology.next[k]);
        if (from.x() < to.x()) sides.push_back({from, to, -1});
        if (from.x() > to.x()) sides.push_back({to, from, 1});
    }
    return sides;
}

/// Area between `base` and the lower of two sides, over their common range of x, m2.
inline double area_below_both(const Side& a, const Side& b, double base) {
    const double from = std::max(a.left.x(), b.left.x());
    const double to = std::min(a.right.x(), b.right.x());
    if (to <= from) return 0;
    const auto height = [&](const Side& s, double x) {
        const double fraction = (x - s.left.x()) / (s.right.x() - s.left.x());
        return s.left.y() + fraction * (s.right.y() - s.left.y()) - base;
    };
    const double a0 = height(a, from), a1 = height(a, to);
    const double b0 = height(b, from), b1 = height(b, to);
    const double d0 = a0 - b0, d1 = a1 - b1;
    if (d0 * d1 >= 0) return (to - from) * (d0 + d1 < 0 ? a0 + a1 : b0 + b1) / 2;
    const double crossing = d0 / (d0 - d1);  // fraction of the range at which the sides cross
    const double height_there = a0 + crossing * (a1 - a0);
    const double before = (d0 < 0 ? a0 : b0) + height_there;
    const double after = (d1 < 0 ? a1 : b1) + height_there;
    return (to - from) * (crossing * before + (1 - crossing) * after) / 2;
}

}  // namespace detail

/// Area of the intersection of two blocks, m2, for any simple polygons with holes. The area of a block is the
/// signed sum of the areas below its sides. The area of the intersection is then the signed sum, over all
/// pairs of sides, of the area below both. Exact up to rounding, 1e-16 of the blocks' area.
inline double overlap_area(const dda::Topology& topology, std::span<const dda::Vec2> vertices, int first,
                           int second) {
    const auto a = detail::sides_of(topology, vertices, first);
    const auto b = detail::sides_of(topology, vertices, second);
    double base = std::numeric_limits<double>::infinity();
    for (const auto* sides : {&a, &b}) {
        for (const auto& side : *sides) base = std::min({base, side.left.y(), side.right.y()});
    }
    double area = 0;
    for (const auto& side : a) {
        for (const auto& other : b)
            area += side.sign * other.sign * detail::area_below_both(side, other, base);
    }
    return area;
}

/// The overlaps of all blocks whose bounding boxes meet, by sweeping over x.
inline std::vector<Overlap> overlaps(const dda::Topology& topology, std::span<const dda::Vec2> vertices) {
    struct Box {
        dda::Vec2 low, high;
    };
    std::vector<Box> boxes;
    for (const dda::BlockIndex b : topology.blocks()) {
        Box box{detail::at(vertices, topology.block_corners[b]),
                detail::at(vertices, topology.block_corners[b])};
        for (const dda::CornerIndex k : topology.corners_of(b)) {
            box.low = box.low.cwiseMin(detail::at(vertices, k));
            box.high = box.high.cwiseMax(detail::at(vertices, k));
        }
        boxes.push_back(box);
    }
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].low.x() < boxes[b].low.x(); });
    std::vector<Overlap> found;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box& a = boxes[order[i]];
        for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low.x() < a.high.x(); ++j) {
            const Box& b = boxes[order[j]];
            if (b.low.y() >= a.high.y() || a.low.y() >= b.high.y()) continue;
            const int first = static_cast<int>(std::min(order[i], order[j]));
            const int second = static_cast<int>(std::max(order[i], order[j]));
            found.push_back({first, second, overlap_area(topology, vertices, first, second)});
        }
    }
    return found;
}

inline double perimeter(const dda::Topology& topology, std::span<const dda::Vec2> vertices, int block) {
    double sum = 0;
    for (const dda::CornerIndex k : topology.corners_of(block)) {
        sum += (detail::at(vertices, topology.next[k]) - detail::at(vertices, k)).norm();
    }
    return sum;
}

/// The largest overlap of two blocks, as its area over the perimeter of the second, m.
inline double largest_overlap_depth(const dda::Topology& topology, std::span<const dda::Vec2> vertices) {
    double deepest = 0;
    for (const Overlap& o : overlaps(topology, vertices))
        deepest = std::max(deepest, o.area / perimeter(topology, vertices, o.second));
    return deepest;
}

}  // namespace rockslope::scene
