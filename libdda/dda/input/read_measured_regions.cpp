#include <algorithm>

#include "common/geometry/polygon.hpp"
#include "dda/block/block_system.hpp"
#include "dda/input/read_mesh.hpp"

namespace rockslope::dda {

namespace {

Ring read_polygon(const ConfigTable& table, const Model& model) {
    Ring ring;
    if (!table.has("polygon")) return ring;
    for (const auto& [x, y] : table.pairs("polygon", Dimension::length))
        ring.push_back({x - model.origin.x(), y - model.origin.y()});
    if (ring.size() < 3)
        table.fail("polygon", "'polygon' in [" + table.path() + "] has fewer than three points",
                   "three points or more");
    return ring;
}

BlockMaterialIndex read_region_material(const ConfigTable& table, const Model& model) {
    if (!table.has("block_material")) return BlockMaterialIndex::none();
    std::vector<std::string> names;
    for (const BlockMaterial& material : model.block_materials) names.push_back(material.name);
    const std::string name = table.choice("block_material", names);
    return std::find(names.begin(), names.end(), name) - names.begin();
}

MeasuredRegion read_measured_region(const ConfigTable& table, const BlockSystem& blocks, const Model& model) {
    MeasuredRegion region;
    region.name = table.string("name");
    for (const MeasuredRegion& other : model.measured_regions)
        if (other.name == region.name)
            table.fail("name", "there are two measured regions '" + region.name + "'", "names that differ");
    const Ring polygon = read_polygon(table, model);
    const BlockMaterialIndex material = read_region_material(table, model);
    if (polygon.empty() && !material.exists())
        table.fail("polygon", "[" + table.path() + "] has neither 'polygon' nor 'block_material'",
                   "one of them or both");
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free) continue;
        const Vec2& centroid = blocks.centroid(block);
        if (material.exists() && model.block_material[block] != material) continue;
        if (!polygon.empty() && side_of_ring(polygon, {centroid.x(), centroid.y()}) < 0) continue;
        region.blocks.push_back(block);
    }
    if (region.blocks.empty())
        table.fail("name", "the measured region '" + region.name + "' has no block that is free to move",
                   "a region with the centroid of a free block");
    return region;
}

}  // namespace

void read_measured_regions(const ConfigTable& run, Model& model) {
    const std::vector<ConfigTable> tables = run.array_of_tables("measured_region");
    if (tables.empty()) return;
    const BlockSystem blocks = initial_block_system(model);
    for (const ConfigTable& table : tables)
        model.measured_regions.push_back(read_measured_region(table, blocks, model));
}

}  // namespace rockslope::dda
