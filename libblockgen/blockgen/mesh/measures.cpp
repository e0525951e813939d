#include "blockgen/mesh/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/base/parallel_sort.hpp"

namespace rockslope::blockgen {

namespace {

/// The area up to which the blocks make up the given fraction of the total area.
double weighted_quantile(const std::vector<double>& sorted_areas, double total, double fraction) {
    double sum = 0;
    for (const double area : sorted_areas) {
        sum += area;
        if (sum >= fraction * total) return area;
    }
    return sorted_areas.empty() ? 0 : sorted_areas.back();
}

/// The interior angle of the block at q between the edges p-q and q-r, rad in (0, 2 pi).
double corner_angle(const Point& p, const Point& q, const Point& r) {
    const double ax = p.x - q.x, ay = p.y - q.y, bx = r.x - q.x, by = r.y - q.y;
    const double angle = std::atan2(bx * ay - by * ax, bx * ax + by * ay);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Whether the angle at q may be smaller than the angle with the given tangent. An infinite tangent means 90
/// degrees or more. This test saves most evaluations of the arc tangent.
bool may_be_below(const Point& p, const Point& q, const Point& r, double tangent) {
    if (std::isinf(tangent)) return true;
    const double ax = p.x - q.x, ay = p.y - q.y, bx = r.x - q.x, by = r.y - q.y;
    const double along = bx * ax + by * ay, across = bx * ay - by * ax;
    return across >= 0 && along >= 0 && across <= (1 + 1e-9) * tangent * along;
}

constexpr CornerSummary none_seen{std::numeric_limits<double>::infinity(), std::numbers::pi};

/// @param tangent of the smallest angle, infinite for 90 degrees or more.
void add_corners(const Ring& ring, double& tangent, CornerSummary& smallest) {
    const std::size_t n = ring.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Point &last = ring[(k + n - 1) % n], &next = ring[(k + 1) % n];
        const double length = std::hypot(next.x - ring[k].x, next.y - ring[k].y);
        smallest.smallest_edge = std::min(smallest.smallest_edge, length);
        if (!may_be_below(last, ring[k], next, tangent)) continue;
        smallest.smallest_angle = std::min(smallest.smallest_angle, corner_angle(last, ring[k], next));
        if (smallest.smallest_angle < std::numbers::pi / 2) tangent = std::tan(smallest.smallest_angle);
    }
}

}  // namespace

Ring ring_points(const BlockMesh& mesh, BlockIndex block, std::size_t ring) {
    Ring points;
    points.reserve(mesh.ring(block, ring).size());
    for (const VertexIndex vertex : mesh.ring(block, ring)) points.push_back(mesh.vertices[vertex]);
    return points;
}

double block_area(const BlockMesh& mesh, BlockIndex block) {
    double twice = 0;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r)
        twice += twice_signed_area(ring_points(mesh, block, r));
    return twice / 2;
}

Point block_centroid(const BlockMesh& mesh, BlockIndex block) {
    const Point o = mesh.vertices[mesh.ring(block, 0)[0]];
    double twice_area = 0, sx = 0, sy = 0;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        const Ring ring = ring_points(mesh, block, r);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const double ax = ring[k].x - o.x, ay = ring[k].y - o.y;
            const double bx = ring[(k + 1) % ring.size()].x - o.x, by = ring[(k + 1) % ring.size()].y - o.y;
            const double cross = ax * by - ay * bx;
            twice_area += cross;
            sx += cross * (ax + bx);
            sy += cross * (ay + by);
        }
    }
    return {o.x + sx / (3 * twice_area), o.y + sy / (3 * twice_area)};
}

double block_perimeter(const BlockMesh& mesh, BlockIndex block) {
    double length = 0;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        const Ring ring = ring_points(mesh, block, r);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Point& next = ring[(k + 1) % ring.size()];
            length += std::hypot(next.x - ring[k].x, next.y - ring[k].y);
        }
    }
    return length;
}

double block_roundness(const BlockMesh& mesh, BlockIndex block) {
    const double perimeter = block_perimeter(mesh, block);
    return 4 * std::numbers::pi * block_area(mesh, block) / (perimeter * perimeter);
}

double block_aspect(const BlockMesh& mesh, BlockIndex block) {
    const Point c = block_centroid(mesh, block);
    double xx = 0, yy = 0, xy = 0;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        const Ring ring = ring_points(mesh, block, r);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const double ax = ring[k].x - c.x, ay = ring[k].y - c.y;
            const double bx = ring[(k + 1) % ring.size()].x - c.x, by = ring[(k + 1) % ring.size()].y - c.y;
            const double cross = ax * by - ay * bx;
            xx += cross * (ax * ax + ax * bx + bx * bx);
            yy += cross * (ay * ay + ay * by + by * by);
            xy += cross * (2 * ax * ay + ax * by + bx * ay + 2 * bx * by) / 2;
        }
    }
    const double mean = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
    return std::sqrt(std::max(mean - spread, 0.0) / (mean + spread));
}

ShapeSummary shape_summary(const BlockMesh& mesh, const ThreadPool& pool) {
    ShapeSummary summary;
    const std::size_t n = mesh.block_count();
    if (n == 0) return summary;
    std::vector<double> roundness(n), aspect(n);
    pool.parallel_for(n, [&](std::size_t begin, std::size_t end) {
        for (const BlockIndex b : indices<BlockIndex>(begin, end)) {
            roundness[b] = block_roundness(mesh, b);
            aspect[b] = block_aspect(mesh, b);
        }
    });
    const auto deciles = [n](std::vector<double>& values) {
        const auto at = [&](double fraction) {
            const auto k = std::min(n - 1, static_cast<std::size_t>(fraction * static_cast<double>(n)));
            const auto place = values.begin() + static_cast<std::ptrdiff_t>(k);
            std::nth_element(values.begin(), place, values.end());
            return *place;
        };
        return Deciles{at(0.1), at(0.5), at(0.9)};
    };
    summary.roundness = deciles(roundness);
    summary.aspect = deciles(aspect);
    summary.mean_corners = static_cast<double>(mesh.corners.size()) / static_cast<double>(n);
    return summary;
}

PerBlock<double> block_areas(const BlockMesh& mesh, const ThreadPool& pool) {
    PerBlock<double> areas(mesh.block_count());
    pool.parallel_for(areas.size(), [&](std::size_t begin, std::size_t end) {
        for (const BlockIndex b : indices<BlockIndex>(begin, end)) areas[b] = block_area(mesh, b);
    });
    return areas;
}

AreaSummary area_summary(std::vector<double> areas, const ThreadPool& pool) {
    AreaSummary summary;
    if (areas.empty()) return summary;
    for (const double area : areas) summary.area += area;
    parallel_sort(pool, areas);
    summary.smallest_area = areas.front();
    summary.largest_area = areas.back();
    summary.d10 = weighted_quantile(areas, summary.area, 0.1);
    summary.d50 = weighted_quantile(areas, summary.area, 0.5);
    summary.d90 = weighted_quantile(areas, summary.area, 0.9);
    return summary;
}

CornerSummary corner_summary(const BlockMesh& mesh, const ThreadPool& pool) {
    if (mesh.block_count() == 0) return {};
    const auto part = [&](std::size_t begin, std::size_t end) {
        CornerSummary smallest = none_seen;
        double tangent = std::numeric_limits<double>::infinity();
        for (const BlockIndex b : indices<BlockIndex>(begin, end))
            for (std::size_t r = 0; r < mesh.ring_count(b); ++r)
                add_corners(ring_points(mesh, b, r), tangent, smallest);
        return smallest;
    };
    const auto smaller = [](const CornerSummary& a, const CornerSummary& b) {
        return CornerSummary{std::min(a.smallest_edge, b.smallest_edge),
                             std::min(a.smallest_angle, b.smallest_angle)};
    };
    return pool.parallel_reduce(mesh.block_count(), none_seen, part, smaller);
}

}  // namespace rockslope::blockgen
