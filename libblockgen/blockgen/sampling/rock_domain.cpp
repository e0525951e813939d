#include "blockgen/sampling/rock_domain.hpp"

#include <algorithm>
#include <cmath>

#include "blockgen/faces/classify_faces.hpp"
#include "blockgen/input/domain.hpp"

namespace rockslope::blockgen {

namespace {

/// The model's outlines and voids without regions, excavations and joints.
SlopeModel bare_domain(const SlopeModel& model) {
    SlopeModel bare;
    bare.grid = model.grid;
    bare.outline = model.outline;
    bare.further_outlines = model.further_outlines;
    bare.holes = model.holes;
    bare.tunnels = model.tunnels;
    return bare;
}

/// Area of the rock, or of the rock in one region, m2, from an arrangement of the outlines without joints.
double area_of(const SlopeModel& model, const Ring* region) {
    SlopeModel bare = bare_domain(model);
    if (region != nullptr) bare.regions.push_back({"region", "region", "", *region, {}});
    const SourceTable table(bare);
    const NodedEdges noded = node_joints(source_segments(bare, {}, table), bare.grid);
    const Subdivision subdivision = arrange(noded);
    const FaceBlocks faces = classify_faces(noded, subdivision, bare, table);
    const auto counts = [&](HalfEdgeIndex half_edge) {
        const FaceBlockIndex block = faces.block[subdivision.face[half_edge]];
        return block != FaceBlocks::outside && (region == nullptr || faces.material[block] == 1);
    };
    Int128 twice = 0;
    for (const EdgeIndex e : noded.edges.indices())
        twice +=
            twice_area({0, 0}, noded.vertices[noded.edges[e].first], noded.vertices[noded.edges[e].second]) *
            (int{counts(forward_half(e))} - int{counts(backward_half(e))});
    return static_cast<double>(twice) / 2 * noded.frame.step * noded.frame.step;
}

double distance(const Point& a, const Point& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// Length of the union of intervals along a line.
double covered_length(std::vector<std::pair<double, double>> intervals) {
    std::sort(intervals.begin(), intervals.end());
    double length = 0, end = 0;
    for (const auto& [from, to] : intervals) {
        length += std::max(to - std::max(from, end), 0.0);
        end = std::max(end, to);
    }
    return length;
}

}  // namespace

RockDomain::RockDomain(const SlopeModel& model, const std::string& region) : model_(model) {
    for (const Region& candidate : model.regions)
        if (candidate.name == region) region_ = &candidate.polygon;
    area_ = area_of(model, region_);
}

double RockDomain::length_in(const Point& a, const Point& b) const {
    double length = 0;
    for (const auto& [c, d] : pieces_in_region(a, b)) {
        length += length_in_part(c, d, model_.outline);
        for (const Ring& part : model_.further_outlines) length += length_in_part(c, d, part);
    }
    return std::max(length, 0.0);
}

double RockDomain::length_in_part(const Point& a, const Point& b, const Ring& part) const {
    double length = 0;
    for (const auto& [p, q] : clip_to_ring(a, b, part)) {
        std::vector<std::pair<double, double>> cavities;  // they may overlap
        const auto subtract = [&, start = p, end = q](const Ring& cavity) {
            for (const auto& [c, d] : clip_to_ring(start, end, cavity))
                cavities.emplace_back(distance(start, c), distance(start, d));
        };
        for (const Ring& hole : model_.holes) subtract(hole);
        for (const Tunnel& tunnel : model_.tunnels) subtract(tunnel.outline);
        length += distance(p, q) - covered_length(std::move(cavities));
    }
    return length;
}

bool RockDomain::contains(const Point& p) const {
    if (region_ != nullptr && side_of_ring(*region_, p) < 0) return false;
    if (!is_in_outlines(model_, p)) return false;
    for (const Ring& hole : model_.holes)
        if (side_of_ring(hole, p) > 0) return false;
    for (const Tunnel& tunnel : model_.tunnels)
        if (side_of_ring(tunnel.outline, p) > 0) return false;
    return true;
}

std::vector<Piece> RockDomain::pieces_in_region(const Point& a, const Point& b) const {
    if (region_ == nullptr) return {{a, b}};
    return clip_to_ring(a, b, *region_);
}

std::vector<Piece> RockDomain::repeated_pieces(const std::vector<Trace>& traces) const {
    const SlopeModel bare = bare_domain(model_);
    const SourceTable table(bare);
    const NodedEdges noded = node_joints(source_segments(bare, traces, table), bare.grid);
    const auto position = [&](NodeIndex n) { return noded.frame.position(noded.vertices[n]); };
    std::vector<Piece> pieces;
    for (const EdgeIndex e : noded.edges.indices()) {
        const auto sources = noded.sources_of(e);
        const auto times = std::count_if(sources.begin(), sources.end(),
                                         [&](const EdgeSource& s) { return table.is_joint(s.source); });
        for (auto k = times; k > 1; --k)
            pieces.emplace_back(position(noded.edges[e].first), position(noded.edges[e].second));
    }
    return pieces;
}

}  // namespace rockslope::blockgen
