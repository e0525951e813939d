#include "common/geometry/indexed_ring.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/orientation.hpp"
#include "common/geometry/pieces_in_ring.hpp"

namespace rockslope {

namespace {

/// Largest number of edges in a box without halves.
constexpr std::size_t leaf_edges = 8;

Bounds box_of(const Point& a, const Point& b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

}  // namespace

IndexedRing::IndexedRing(const Ring& ring) : ring_(ring) {
    if (ring.empty()) return;
    ring_.push_back(ring.front());
    build(0, 0, ring.size());
}

void IndexedRing::build(std::size_t node, std::size_t first, std::size_t last) {
    if (boxes_.size() <= node) boxes_.resize(node + 1);
    if (last - first <= leaf_edges) {
        Bounds box = box_of(ring_[first], ring_[first + 1]);
        for (std::size_t k = first + 1; k < last; ++k) {
            const Point& p = ring_[k + 1];
            box = {{std::min(box.low.x, p.x), std::min(box.low.y, p.y)},
                   {std::max(box.high.x, p.x), std::max(box.high.y, p.y)}};
        }
        boxes_[node] = box;
        return;
    }
    const std::size_t middle = first + (last - first) / 2;
    build(2 * node + 1, first, middle);
    build(2 * node + 2, middle, last);
    const Bounds &a = boxes_[2 * node + 1], &b = boxes_[2 * node + 2];
    boxes_[node] = {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
                    {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

template <class Visit>
void IndexedRing::visit_edges(const Bounds& box, const Visit& visit, std::size_t node, std::size_t first,
                              std::size_t last) const {
    if (!overlap(boxes_[node], box)) return;
    if (last - first <= leaf_edges) {
        for (std::size_t k = first; k < last; ++k) visit(ring_[k], ring_[k + 1]);
        return;
    }
    const std::size_t middle = first + (last - first) / 2;
    visit_edges(box, visit, 2 * node + 1, first, middle);
    visit_edges(box, visit, 2 * node + 2, middle, last);
}

template <class Visit>
void IndexedRing::visit_edges(const Bounds& box, const Visit& visit) const {
    if (!boxes_.empty()) visit_edges(box, visit, 0, 0, ring_.size() - 1);
}

int IndexedRing::side(const Point& point) const {
    if (boxes_.empty()) return -1;
    bool inside = false, on_edge = false;
    // The edges above the point and those through it, by the even-odd rule.
    visit_edges({point, {point.x, boxes_[0].high.y}}, [&](Point a, Point b) {
        if (a.x > b.x) std::swap(a, b);
        if (point.x < a.x || point.x > b.x) return;
        const int turn = orientation(a, b, point);
        on_edge = on_edge || (turn == 0 && std::min(a.y, b.y) <= point.y && point.y <= std::max(a.y, b.y));
        if (point.x < b.x && turn < 0) inside = !inside;
    });
    return on_edge ? 0 : inside ? 1 : -1;
}

std::vector<std::pair<Point, Point>> IndexedRing::clip(const Point& a, const Point& b) const {
    // Widened: clip_to_ring() takes edges, too, that the segment meets by rounding only.
    constexpr double clip_rounding = 1e-12;
    const Bounds box = box_of(a, b);
    const double size = std::max({std::abs(box.low.x), std::abs(box.high.x), std::abs(box.low.y),
                                  std::abs(box.high.y), box.high.x - box.low.x, box.high.y - box.low.y});
    return pieces_in_ring(
        a, b, [&](const auto& visit) { visit_edges(box.expanded(clip_rounding * size), visit); },
        [&](const Point& p) { return side(p); });
}

}  // namespace rockslope
