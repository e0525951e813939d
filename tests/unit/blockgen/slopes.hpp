#pragma once

#include <string>

#include "blockgen/config/config_table.hpp"
#include "blockgen/cut_blocks.hpp"
#include "blockgen/input/read_slope_model.hpp"
#include "blockgen/sample_joints.hpp"

namespace blockgen {

inline SlopeModel slope(const std::string& text) {
    return read_slope_model(ConfigTable::from_text(text, "slope.toml"));
}

/// A rectangle from the origin, of rock, without joints.
inline SlopeModel rectangle(double width, double height) {
    SlopeModel model;
    model.outline = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    model.block_material = "rock";
    return model;
}

inline void add_trace(SlopeModel& model, std::vector<Point> points, const std::string& name = "joint") {
    model.traces.push_back({name, name, std::move(points)});
}

inline CutResult cut(const SlopeModel& model, bool verify = true) {
    CutOptions options;
    options.verify = verify;
    return cut_blocks(model, all_traces(model), options);
}

}  // namespace blockgen
