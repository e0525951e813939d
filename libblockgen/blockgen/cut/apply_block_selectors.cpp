#include "blockgen/cut/apply_block_selectors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "blockgen/input/domain.hpp"
#include "blockgen/mesh/measures.hpp"
#include "common/geometry/point_text.hpp"
#include "common/geometry/segment.hpp"

namespace rockslope::blockgen {

namespace {

bool contains(const BlockMesh& mesh, BlockIndex block, const Point& p) {
    bool in_box_x = false, in_box_y = false, below_x = false, below_y = false;
    for (const VertexIndex v : mesh.ring(block, 0)) {
        const Point& q = mesh.vertices[v];
        below_x = below_x || q.x <= p.x;
        in_box_x = in_box_x || q.x >= p.x;
        below_y = below_y || q.y <= p.y;
        in_box_y = in_box_y || q.y >= p.y;
    }
    if (!(below_x && in_box_x && below_y && in_box_y)) return false;
    if (side_of_ring(ring_points(mesh, block, 0), p) < 0) return false;
    for (std::size_t r = 1; r < mesh.ring_count(block); ++r)
        if (side_of_ring(ring_points(mesh, block, r), p) > 0) return false;
    return true;
}

std::pair<BlockIndex, double> nearest_block(const BlockMesh& mesh, const Point& p) {
    std::pair<BlockIndex, double> nearest{BlockIndex::none(), std::numeric_limits<double>::infinity()};
    for (const BlockIndex b : mesh.blocks())
        for (std::size_t r = 0; r < mesh.ring_count(b); ++r) {
            const Ring ring = ring_points(mesh, b, r);
            for (std::size_t k = 0; k < ring.size(); ++k)
                if (const double d = distance_to_segment(p, ring[k], ring[(k + 1) % ring.size()]);
                    d < nearest.second)
                    nearest = {b, d};
        }
    return nearest;
}

BlockIndex block_near(const BlockMesh& mesh, const SlopeModel& model, const BlockSelector& selector,
                      std::vector<std::string>& warnings) {
    const BlockIndex block = block_at(mesh, *selector.at);
    if (block.exists()) return block;
    const Bounds bounds = domain_bounds(model);
    const double reach = 0.05 * std::hypot(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
    const auto [nearest, distance] = nearest_block(mesh, *selector.at);
    if (distance > reach)
        throw InputError(selector.place, "no block contains the point " + text_of(*selector.at),
                         "a point inside the rock");
    if (distance <= 2 * model.grid) return nearest;
    char metres[32];
    std::snprintf(metres, sizeof metres, "%.3g", distance);
    warnings.push_back(selector.place.text() + ": the point " + text_of(*selector.at) +
                       " lies outside the rock; the nearest block, " + metres + " m away, is used");
    return nearest;
}

/// Whether a block has a free edge along a side of the box.
bool lies_along(const BlockMesh& mesh, BlockIndex block, const std::string& side, const Bounds& bounds,
                double tolerance) {
    const auto is_there = [&](const Point& p) {
        if (side == "bottom") return p.y <= bounds.low.y + tolerance;
        if (side == "top") return p.y >= bounds.high.y - tolerance;
        if (side == "left") return p.x <= bounds.low.x + tolerance;
        return p.x >= bounds.high.x - tolerance;
    };
    const Ring ring = ring_points(mesh, block, 0);
    for (std::size_t k = 0; k < ring.size(); ++k)
        if (is_there(ring[k]) && is_there(ring[(k + 1) % ring.size()])) return true;
    return false;
}

/// Whether a segment has a piece inside a block, or along its boundary.
bool runs_through(const BlockMesh& mesh, BlockIndex block, const Point& a, const Point& b) {
    for (const auto& [p, q] : clip_to_ring(a, b, ring_points(mesh, block, 0))) {
        const Point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
        if (contains(mesh, block, middle)) return true;
    }
    return false;
}

std::vector<BlockIndex> selected_blocks(const BlockMesh& mesh, const SlopeModel& model,
                                        const BlockSelector& selector, std::vector<std::string>& warnings) {
    if (selector.at) return {block_near(mesh, model, selector, warnings)};
    std::vector<BlockIndex> blocks;
    const Bounds bounds = domain_bounds(model);
    for (const BlockIndex b : mesh.blocks()) {
        const bool is_selected =
            !selector.along.empty() ? runs_through(mesh, b, selector.along[0], selector.along[1])
            : selector.side.empty() ? side_of_ring(selector.inside, block_centroid(mesh, b)) >= 0
                                    : lies_along(mesh, b, selector.side, bounds, 4 * model.grid);
        if (is_selected) blocks.push_back(b);
    }
    if (blocks.empty())
        throw InputError(selector.place, "no block is selected",
                         !selector.along.empty() ? "a line that runs through a block"
                         : selector.side.empty() ? "a polygon that contains the centroid of a block"
                                                 : "a side that a block lies along");
    return blocks;
}

BlockIndex block_containing(const BlockMesh& mesh, const Point& p, const SourceLocation& place,
                            const std::string& what) {
    const BlockIndex block = block_at(mesh, p);
    if (!block.exists())
        throw InputError(place, "no block contains " + what + " at " + text_of(p), "a point inside the rock");
    return block;
}

}  // namespace

BlockIndex block_at(const BlockMesh& mesh, const Point& p) {
    for (const BlockIndex b : mesh.blocks())
        if (contains(mesh, b, p)) return b;
    return BlockIndex::none();
}

static void apply_material_lines(BlockMesh& mesh, const SlopeModel& model) {
    if (model.material_lines.empty()) return;
    PerBlockMaterial<std::string> names = mesh.block_materials;
    for (const MaterialLine& line : model.material_lines) {
        const auto found = std::find(names.begin(), names.end(), line.block_material);
        const BlockMaterialIndex material = found - names.begin();
        if (found == names.end()) names.push_back(line.block_material);
        for (const BlockIndex b : mesh.blocks())
            if (runs_through(mesh, b, line.from, line.to)) mesh.block_material[b] = material;
    }
    // Only materials that a block has are written to the file.
    PerBlockMaterial<BlockMaterialIndex> number(names.size(), -1);
    mesh.block_materials.clear();
    for (BlockMaterialIndex& material : mesh.block_material) {
        BlockMaterialIndex& n = number[material];
        if (!n.exists()) {
            n = mesh.block_materials.size();
            mesh.block_materials.push_back(names[material]);
        }
        material = n;
    }
}

void apply_block_selectors(BlockMesh& mesh, const SlopeModel& model, std::vector<std::string>& warnings) {
    apply_material_lines(mesh, model);
    for (const BlockSelector& selector : model.selectors) {
        const BlockMotion motion = selector.prescribed ? BlockMotion::prescribed : BlockMotion::fixed;
        for (const BlockIndex b : selected_blocks(mesh, model, selector, warnings)) {
            const bool contradicts =
                mesh.motion[b] != BlockMotion::free &&
                (mesh.motion[b] != motion || (selector.prescribed && mesh.motion_name[b] != selector.name));
            if (contradicts)
                throw InputError(selector.place,
                                 "block " + std::to_string(b.value()) + " near " +
                                     text_of(block_centroid(mesh, b)) +
                                     " is already fixed, or prescribed under another name",
                                 "one motion for each block");
            mesh.motion[b] = motion;
            if (selector.prescribed) mesh.motion_name[b] = selector.name;
        }
    }
    for (const NamedPoint& point : model.measured_points)
        mesh.measured_points.push_back(
            {point.name, block_containing(mesh, point.at, point.place, "measured point '" + point.name + "'"),
             point.at});
    mesh.water_table = model.water_table;
    for (const BoltLine& bolt : model.bolts) {
        const std::string what = "bolt '" + bolt.name + "'";
        mesh.bolts.push_back(
            {bolt.name, bolt.material, block_containing(mesh, bolt.from, bolt.place, "the start of " + what),
             block_containing(mesh, bolt.to, bolt.place, "the end of " + what), bolt.from, bolt.to});
    }
}

}  // namespace rockslope::blockgen
