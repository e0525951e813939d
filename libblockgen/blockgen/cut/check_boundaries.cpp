#include "blockgen/cut/check_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "blockgen/input/domain.hpp"
#include "blockgen/mesh/measures.hpp"

namespace rockslope::blockgen {

namespace {

/// A held block with less than this share of the mean area of the others cannot be what a slope stands on.
constexpr double tiny_share = 0.01;

/// A shorter length of a side that nothing holds, as a share of the side, is a corner of a block.
constexpr double negligible_rim = 0.05;

template <class... Values>
std::string sentence(const char* format, Values... values) {
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

/// The rim along one side of the section, m.
struct Rim {
    const char* side;
    double length = 0, loose = 0;
};

void add_edge(Rim& rim, const Point& a, const Point& b, bool is_held) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    rim.length += length;
    if (!is_held) rim.loose += length;
}

std::vector<Rim> rims_of(const BlockMesh& mesh, const SlopeModel& model) {
    const Bounds box = domain_bounds(model);
    const double tolerance = 4 * model.grid;
    std::vector<Rim> rims = {{"left"}, {"right"}, {"lower"}};
    for (const BlockIndex b : mesh.blocks()) {
        const bool is_held = mesh.motion[b] != BlockMotion::free;
        const Ring ring = ring_points(mesh, b, 0);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
            if (std::max(p.x, q.x) <= box.low.x + tolerance) add_edge(rims[0], p, q, is_held);
            if (std::min(p.x, q.x) >= box.high.x - tolerance) add_edge(rims[1], p, q, is_held);
            if (std::max(p.y, q.y) <= box.low.y + tolerance) add_edge(rims[2], p, q, is_held);
        }
    }
    return rims;
}

/// Whether a region lies outside the section: no block is of its rock, and its outline is along none.
bool is_outside(const CutContext& cut, SourceIndex region) {
    const RockIndex rock(region - cut.table.first_region + 1);
    if (std::find(cut.faces.material.begin(), cut.faces.material.end(), rock) != cut.faces.material.end())
        return false;
    return std::none_of(cut.noded.edges.indices().begin(), cut.noded.edges.indices().end(), [&](EdgeIndex e) {
        const auto sources = cut.noded.sources_of(e);
        const bool along = std::any_of(sources.begin(), sources.end(),
                                       [&](const EdgeSource& s) { return s.source == region; });
        return along && (cut.block_of(forward_half(e)) != FaceBlocks::outside ||
                         cut.block_of(backward_half(e)) != FaceBlocks::outside);
    });
}

/// Whether the outline of a region runs between two faces of one block without a joint.
bool is_fused(const CutContext& cut, SourceIndex region) {
    for (const EdgeIndex e : cut.noded.edges.indices()) {
        bool along = false, has_joint = false;
        for (const EdgeSource& s : cut.noded.sources_of(e)) {
            along = along || s.source == region;
            has_joint = has_joint || cut.table.is_joint(s.source);
        }
        if (!along || has_joint) continue;
        const FaceBlockIndex left = cut.block_of(forward_half(e)), right = cut.block_of(backward_half(e));
        if (left != right || left == FaceBlocks::outside) continue;
        // A later region lies over this one there, such as the base.
        if (cut.faces.material[left] > static_cast<std::int32_t>(region - cut.table.first_region) + 1)
            continue;
        return true;
    }
    return false;
}

}  // namespace

std::vector<std::string> boundary_warnings(const BlockMesh& mesh, const SlopeModel& model) {
    std::vector<std::string> warnings;
    double free_area = 0;
    std::size_t free_blocks = 0;
    for (const BlockIndex b : mesh.blocks())
        if (mesh.motion[b] == BlockMotion::free) ++free_blocks, free_area += block_area(mesh, b);
    if (free_blocks == mesh.block_count() || free_blocks == 0) return warnings;
    const double mean_area = free_area / static_cast<double>(free_blocks);
    for (const BlockIndex b : mesh.blocks()) {
        if (mesh.motion[b] != BlockMotion::prescribed || block_area(mesh, b) >= tiny_share * mean_area)
            continue;
        const Point at = block_centroid(mesh, b);
        warnings.push_back(
            sentence("prescribed block '%s' at (%.6g, %.6g) is tiny: %.3g m2, where the other "
                     "blocks have %.3g m2 on average",
                     mesh.motion_name[b].c_str(), at.x, at.y, block_area(mesh, b), mean_area));
    }
    for (const Rim& rim : rims_of(mesh, model))
        if (rim.loose > negligible_rim * rim.length)
            warnings.push_back(
                sentence("nothing holds %.4g m of the %.4g m of the section's %s side: fix or "
                         "prescribe the blocks there, by [base] for instance, or let the run "
                         "hold them by a viscous boundary",
                         rim.loose, rim.length, rim.side));
    return warnings;
}

std::vector<std::string> region_warnings(const CutContext& cut) {
    std::vector<std::string> warnings;
    for (const SourceIndex source : indices(cut.table.first_region, cut.table.first_excavation)) {
        const Region& region = cut.model.regions[source - cut.table.first_region];
        if (is_outside(cut, source)) {
            warnings.push_back(std::string(region.kind) + " '" + region.name + "' lies outside the section");
            continue;
        }
        const bool has_cells = std::any_of(
            cut.model.joint_sets.begin(), cut.model.joint_sets.end(),
            [&](const JointSet& set) { return set.kind == SetKind::voronoi && set.region == region.name; });
        if ((region.joint_material.empty() && !has_cells) || !is_fused(cut, source)) continue;
        if (!region.joint_material.empty())
            warnings.push_back(std::string(region.kind) + " '" + region.name + "': its joint_material '" +
                               region.joint_material +
                               "' has no effect where the rock outside has the same block material '" +
                               region.block_material +
                               "'; a material of its own, or traces, would part them");
        if (has_cells)
            warnings.push_back(
                std::string(region.kind) + " '" + region.name +
                "': the outer Voronoi cells are one block with the rock outside where no joint "
                "runs along its outline; a block material of its own would part them");
    }
    return warnings;
}

}  // namespace rockslope::blockgen
