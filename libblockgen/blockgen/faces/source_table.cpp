#include "blockgen/faces/source_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "blockgen/input/domain.hpp"

namespace rockslope::blockgen {

namespace {

void add_ring(std::vector<SourceSegment>& segments, const Ring& ring, SourceIndex source) {
    for (std::size_t k = 0; k < ring.size(); ++k)
        segments.push_back({ring[k], ring[(k + 1) % ring.size()], source});
}

}  // namespace

SourceTable::SourceTable(const SlopeModel& model) {
    first_region = first_hole + model.holes.size();
    first_excavation = first_region + model.regions.size();
    first_tunnel = first_excavation + model.excavations.size();
    first_joint = first_tunnel + model.tunnels.size();
}

std::vector<SourceSegment> source_segments(const SlopeModel& model, const std::vector<Trace>& traces,
                                           const SourceTable& table) {
    std::vector<SourceSegment> segments;
    add_ring(segments, model.outline, 0);
    for (const Ring& part : model.further_outlines) add_ring(segments, part, 0);
    for (std::size_t k = 0; k < model.holes.size(); ++k)
        add_ring(segments, model.holes[k], table.first_hole + k);
    for (std::size_t k = 0; k < model.regions.size(); ++k)
        add_ring(segments, model.regions[k].polygon, table.first_region + k);
    for (std::size_t k = 0; k < model.excavations.size(); ++k)
        add_ring(segments, model.excavations[k].outline, table.first_excavation + k);
    for (std::size_t k = 0; k < model.tunnels.size(); ++k)
        add_ring(segments, model.tunnels[k].outline, table.first_tunnel + k);

    const Bounds bounds = domain_bounds(model);
    const double size = std::hypot(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
    const Bounds reach = bounds.expanded(0.01 * size + 16 * model.grid);
    for (const JointTraceIndex trace : indices<JointTraceIndex>(traces.size())) {
        const std::vector<Point>& points = traces[trace].points;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Point &a = points[i], &b = points[i + 1];
            const Point u{b.x - a.x, b.y - a.y};
            const auto inside = reach.clip(a, u);
            if (!inside) continue;
            const auto at = [&](double t) {
                return t <= 0 ? a : t >= 1 ? b : Point{a.x + t * u.x, a.y + t * u.y};
            };
            const double first = std::max(inside->first, 0.0), last = std::min(inside->second, 1.0);
            if (first < last) segments.push_back({at(first), at(last), table.source_of(trace)});
        }
    }
    return segments;
}

double estimated_blocks(const SlopeModel& model, const std::vector<SourceSegment>& segments,
                        const SourceTable& table) {
    // Randomly placed lines of lengths L1 and L2 at the angle a cross L1 L2 |sin a| / A times on average in
    // an area A.
    constexpr std::size_t bins = 36;
    std::array<double, bins> length{};
    for (const SourceSegment& s : segments) {
        if (!table.is_joint(s.source)) continue;
        const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
        const double turn = std::atan2(dy, dx) / std::numbers::pi + 1;
        length[static_cast<std::size_t>(turn * bins) % bins] += std::hypot(dx, dy);
    }
    const Bounds bounds = domain_bounds(model);
    const double area = (bounds.high.x - bounds.low.x) * (bounds.high.y - bounds.low.y);
    double crossings = 0;
    for (std::size_t i = 0; i < bins; ++i)
        for (std::size_t j = 0; j < i; ++j)
            crossings +=
                length[i] * length[j] * std::sin(std::numbers::pi * static_cast<double>(i - j) / bins) / area;
    return crossings;
}

}  // namespace rockslope::blockgen
