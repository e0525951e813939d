#include <cstdio>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/read_geology.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "blockgen/input/surface.hpp"

namespace rockslope::blockgen {

namespace {

/// A layer while its extent is found.
struct Layer {
    ConfigTable table;
    Region region;              ///< without its polygon
    std::vector<Point> points;  ///< of its top, as given
    HeightLine top;             ///< across the domain, nowhere above the top of the layer before
};

Layer read_layer(const ConfigTable& table, SlopeModel& model) {
    Layer layer{table, {}, {}, {}};
    layer.region.kind = "layer";
    layer.region.place = table.place();
    layer.region.name = read_name(table, "name");
    layer.region.block_material = table.string("block_material", model.block_material);
    layer.region.joint_material = table.string("joint_material", "");
    layer.points = read_line_across(
        table, "top",
        "points from one side to the other, whose x never turns back; a [[region]] may be folded", model);
    return layer;
}

/// Cuts the top of a layer off where it lies above the top of the layer before, and notes it.
void cut_off(Layer& layer, const Layer& before, SlopeModel& model) {
    const Rise rise = largest_rise(layer.top, before.top, layer.points.front().x, layer.points.back().x);
    if (rise.height > model.grid) {
        char where[64];
        std::snprintf(where, sizeof where, "%.4g m, at x = %.10g", rise.height, rise.at.x);
        model.notes.push_back("layer '" + layer.region.name + "': its top is cut off by that of layer '" +
                              before.region.name + "', above which it lies by up to " + where);
    }
    layer.top = lower_of(before.top, layer.top);
}

}  // namespace

void read_layers(const ConfigTable& root, SlopeModel& model) {
    const auto tables = root.array_of_tables("layer");
    if (tables.empty()) return;
    const Bounds box = domain_bounds(model);
    std::vector<Layer> layers;
    for (const ConfigTable& table : tables) {
        Layer layer = read_layer(table, model);
        layer.top = clamped(height_line(layer.points, box.low.x, box.high.x), box.low.y, box.high.y);
        if (!layers.empty()) cut_off(layer, layers.back(), model);
        layers.push_back(std::move(layer));
    }
    const HeightLine surface = ground_surface(model), bottom = {box.low, {box.high.x, box.low.y}};
    for (std::size_t k = 0; k < layers.size(); ++k) {
        Layer& layer = layers[k];
        const HeightLine& base = k + 1 < layers.size() ? layers[k + 1].top : bottom;
        if (ring_between(lower_of(layer.top, surface), lower_of(base, surface)).empty())
            layer.table.fail(layer.table.has("top") ? "top" : "top_file",
                             "layer '" + layer.region.name + "' has no rock" +
                                 (k + 1 < layers.size() ? " between its top and that of layer '" +
                                                              layers[k + 1].region.name + "'"
                                                        : " below its top"),
                             "layers from the highest to the lowest, with tops within the section");
        layer.region.polygon = ring_between(layer.top, base);
        add_region(layer.table, std::move(layer.region), model);
    }
}

}  // namespace rockslope::blockgen
