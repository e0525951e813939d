#include <algorithm>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/read_geology.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "blockgen/input/surface.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

struct WeatheredZone {
    ConfigTable table;
    Region region;     ///< without its polygon
    double depth = 0;  ///< m, of its base below the surface
};

WeatheredZone read_zone(const ConfigTable& table, double grid) {
    WeatheredZone zone{table, {}, 0};
    zone.region.kind = "weathered zone";
    zone.region.place = table.place();
    zone.region.name = table.string("name", "weathered");
    zone.region.block_material = table.string("block_material", "");
    zone.region.joint_material = table.string("joint_material", "");
    if (zone.region.name.empty()) table.fail("name", "'name' in [" + table.path() + "] is empty", "a name");
    if (zone.region.block_material.empty() && !zone.region.joint_material.empty())
        table.fail("joint_material", "a contact of a zone without block_material", "block_material as well");
    zone.depth = table.checked(
        "depth", table.number("depth", Dimension::length), [&](double d) { return d >= 4 * grid; },
        "a depth below the surface of at least four times the grid of " + shortest_text(grid) + " m");
    return zone;
}

std::vector<WeatheredZone> read_zones(const ConfigTable& root, double grid) {
    std::vector<WeatheredZone> zones;
    if (root.is_table("weathered"))
        zones.push_back(read_zone(root.table("weathered"), grid));
    else
        for (const ConfigTable& table : root.array_of_tables("weathered"))
            zones.push_back(read_zone(table, grid));
    std::stable_sort(zones.begin(), zones.end(),
                     [](const WeatheredZone& a, const WeatheredZone& b) { return a.depth < b.depth; });
    for (std::size_t k = 1; k < zones.size(); ++k)
        if (zones[k].depth - zones[k - 1].depth < 4 * grid)
            zones[k].table.fail("depth",
                                "weathered zones '" + zones[k - 1].region.name + "' and '" +
                                    zones[k].region.name + "' reach to the same depth",
                                "a depth for each zone");
    return zones;
}

}  // namespace

void read_weathered_zones(const ConfigTable& root, SlopeModel& model) {
    std::vector<WeatheredZone> zones = read_zones(root, model.grid);
    if (zones.empty()) return;
    const Bounds box = domain_bounds(model);
    const HeightLine surface = ground_surface(model);
    HeightLine upper = surface;
    for (WeatheredZone& zone : zones) {
        HeightLine lower = upper_of(moved_up(surface, -zone.depth), {box.low, {box.high.x, box.low.y}});
        zone.region.polygon = ring_between(upper, lower);
        if (zone.region.polygon.empty())
            zone.table.fail("depth",
                            "weathered zone '" + zone.region.name + "' lies below the domain, under '" +
                                model.regions.back().name + "'",
                            "depths less than the height of the section");
        add_region(zone.table, std::move(zone.region), model);
        upper = std::move(lower);
    }
}

}  // namespace rockslope::blockgen
