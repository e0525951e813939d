#include "blockgen/sampling/rock_domain.hpp"

#include <algorithm>
#include <cmath>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

namespace {

/// The model's outlines and voids without regions, excavations and joints.
SlopeModel bare_domain(const SlopeModel& model) {
    SlopeModel bare;
    bare.grid = model.grid;
    bare.outline = model.outline;
    bare.further_outlines = model.further_outlines;
    bare.holes = model.holes;
    bare.holes_location = model.holes_location;
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
    const Ring* polygon = nullptr;
    for (const Region& candidate : model.regions)
        if (candidate.name == region) polygon = &candidate.polygon;
    if (polygon != nullptr) region_.emplace(*polygon);
    parts_.emplace_back(model.outline);
    for (const Ring& part : model.further_outlines) parts_.emplace_back(part);
    for (const Ring& hole : model.holes) cavities_.emplace_back(hole);
    for (const Tunnel& tunnel : model.tunnels) cavities_.emplace_back(tunnel.outline);
    area_ = area_of(model, polygon);
}

double RockDomain::length_in(const Point& a, const Point& b) const {
    double length = 0;
    for (const auto& [c, d] : pieces_in_region(a, b))
        for (const IndexedRing& part : parts_) length += length_in_part(c, d, part);
    return std::max(length, 0.0);
}

double RockDomain::length_in_part(const Point& a, const Point& b, const IndexedRing& part) const {
    double length = 0;
    for (const auto& [p, q] : part.clip(a, b)) {
        std::vector<std::pair<double, double>> intervals;  // they may overlap
        for (const IndexedRing& cavity : cavities_)
            for (const auto& [c, d] : cavity.clip(p, q))
                intervals.emplace_back(distance(p, c), distance(p, d));
        length += distance(p, q) - covered_length(std::move(intervals));
    }
    return length;
}

bool RockDomain::contains(const Point& p) const {
    if (region_ && region_->side(p) < 0) return false;
    return std::any_of(parts_.begin(), parts_.end(), [&](const IndexedRing& r) { return r.side(p) >= 0; }) &&
           std::none_of(cavities_.begin(), cavities_.end(),
                        [&](const IndexedRing& r) { return r.side(p) > 0; });
}

std::vector<Piece> RockDomain::pieces_in_region(const Point& a, const Point& b) const {
    if (!region_) return {{a, b}};
    return region_->clip(a, b);
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
