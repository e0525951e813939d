#pragma once

#include <string>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/faces/enclosed_area.hpp"
#include "blockgen/sampling/sample_joints.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

inline SlopeModel slope(const std::string& text) {
    return read_slope_model(ConfigTable::from_text(text, "slope.toml"), enclosed_area);
}

/// A rectangle of rock with its lower left corner at the origin, without joints.
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

}  // namespace rockslope::blockgen
