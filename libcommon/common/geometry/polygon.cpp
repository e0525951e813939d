#include "common/geometry/polygon.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "common/geometry/orientation.hpp"

namespace rockslope {

namespace {

struct RingEdge {
    std::size_t ring, edge, ring_size;
    Point a, b;
    double low() const { return std::min(a.x, b.x); }
    double high() const { return std::max(a.x, b.x); }
};

std::vector<RingEdge> edges_of(std::span<const Ring> rings) {
    std::vector<RingEdge> edges;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t k = 0; k < rings[r].size(); ++k)
            edges.push_back({r, k, rings[r].size(), rings[r][k], rings[r][(k + 1) % rings[r].size()]});
    return edges;
}

bool are_neighbours(const RingEdge& e, const RingEdge& f) {
    return e.ring == f.ring && ((e.edge + 1) % e.ring_size == f.edge || (f.edge + 1) % f.ring_size == e.edge);
}

bool may_meet(const RingEdge& e, const RingEdge& f, SegmentRelation how) {
    if (how == SegmentRelation::apart) return true;
    if (how == SegmentRelation::endpoint) return e.ring != f.ring || are_neighbours(e, f);
    return how == SegmentRelation::touching && e.ring != f.ring;
}

Point common_point(const RingEdge& e, const RingEdge& f) {
    for (const Point& p : {f.a, f.b})
        if (orientation(e.a, e.b, p) == 0) return p;
    for (const Point& p : {e.a, e.b})
        if (orientation(f.a, f.b, p) == 0) return p;
    const double ux = e.b.x - e.a.x, uy = e.b.y - e.a.y, vx = f.b.x - f.a.x, vy = f.b.y - f.a.y;
    const double t = ((f.a.x - e.a.x) * vy - (f.a.y - e.a.y) * vx) / (ux * vy - uy * vx);
    return {e.a.x + t * ux, e.a.y + t * uy};
}

RingFault fault_of(const RingEdge& e, const RingEdge& f) {
    const bool in_order = std::pair(e.ring, e.edge) <= std::pair(f.ring, f.edge);
    const RingEdge& first = in_order ? e : f;
    const RingEdge& second = in_order ? f : e;
    return {first.ring, first.edge, second.ring, second.edge, common_point(first, second)};
}

bool boxes_apart_in_y(const RingEdge& e, const RingEdge& f) {
    return std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) || std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y);
}

/// Whether a ring turns left at each vertex and winds once in all. It is then convex, and so simple. Exact.
bool is_strictly_convex(const Ring& ring) {
    const std::size_t n = ring.size();
    const auto is_ascending = [&](std::size_t k) {
        const Point &a = ring[k], &b = ring[(k + 1) % n];
        return b.y > a.y || (b.y == a.y && b.x > a.x);
    };
    int turns_upwards = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        if (orientation(ring[k], ring[next], ring[(k + 2) % n]) <= 0) return false;
        turns_upwards += !is_ascending(k) && is_ascending(next);
    }
    return n >= 3 && turns_upwards == 1;
}

}  // namespace

double twice_signed_area(std::span<const Point> ring) {
    double sum = 0;
    if (ring.size() < 3) return sum;
    const Point& o = ring[0];
    for (std::size_t k = 1; k + 1 < ring.size(); ++k)
        sum += (ring[k].x - o.x) * (ring[k + 1].y - o.y) - (ring[k].y - o.y) * (ring[k + 1].x - o.x);
    return sum;
}

Point centroid(std::span<const Point> ring) {
    const Point& origin = ring.front();
    double twice_area = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& next = ring[(i + 1) % ring.size()];
        const Point p{ring[i].x - origin.x, ring[i].y - origin.y}, q{next.x - origin.x, next.y - origin.y};
        const double part = p.x * q.y - p.y * q.x;
        twice_area += part;
        x += part * (p.x + q.x);
        y += part * (p.y + q.y);
    }
    if (twice_area == 0) return origin;
    return {origin.x + x / (3 * twice_area), origin.y + y / (3 * twice_area)};
}

int side_of_ring(std::span<const Point> ring, const Point& point) {
    bool inside = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        Point a = ring[k];
        Point b = ring[(k + 1) % ring.size()];
        if (a.y > b.y) std::swap(a, b);
        if (point.y < a.y || point.y > b.y) continue;
        const int side = orientation(a, b, point);
        if (side == 0 && std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x)) return 0;
        if (point.y < b.y && side > 0) inside = !inside;
    }
    return inside ? 1 : -1;
}

std::optional<RingFault> find_ring_fault(std::span<const Ring> rings) {
    if (rings.size() == 1 && is_strictly_convex(rings[0])) return std::nullopt;
    std::vector<RingEdge> edges = edges_of(rings);
    for (const RingEdge& e : edges)
        if (e.a == e.b) return RingFault{e.ring, e.edge, e.ring, e.edge, e.a};
    std::sort(edges.begin(), edges.end(), [](const RingEdge& e, const RingEdge& f) {
        return std::tuple(e.low(), e.ring, e.edge) < std::tuple(f.low(), f.ring, f.edge);
    });
    std::vector<const RingEdge*> active;
    for (const RingEdge& edge : edges) {
        std::erase_if(active, [&](const RingEdge* other) { return other->high() < edge.low(); });
        for (const RingEdge* other : active) {
            if (boxes_apart_in_y(*other, edge)) continue;
            const SegmentRelation how = segment_relation(other->a, other->b, edge.a, edge.b);
            if (!may_meet(*other, edge, how)) return fault_of(*other, edge);
        }
        active.push_back(&edge);
    }
    return std::nullopt;
}

}  // namespace rockslope
