#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/read_shapes.hpp"

namespace rockslope::blockgen {

namespace {

void read_traces(const ConfigTable& table, SlopeModel& model) {
    const std::string fallback = "traces " + std::to_string(model.traces.size() + 1);
    const std::string material = table.string("joint_material", "");
    const std::string name = table.string("name", material.empty() ? fallback : material);
    if (table.has("points") == table.has("file"))
        table.fail("points", "traces need points or a file", "exactly one of them");
    if (table.has("file")) {
        model.files.push_back(table.file_path("file"));
        for (Trace& trace : read_trace_file(model.files.back(), name, material)) {
            check_coordinate_range(table, "file", trace.points, model);
            model.traces.push_back(std::move(trace));
        }
        return;
    }
    if (material.empty())
        table.fail("joint_material", "a trace without joint_material", "the name of a joint material");
    Trace trace{name, material, {}};
    for (const auto& pair : table.pairs("points", Dimension::length)) trace.points.push_back(point_of(pair));
    if (trace.points.size() < 2)
        table.fail("points", "a trace of fewer than two points", "two points or more");
    check_coordinate_range(table, "points", trace.points, model);
    model.traces.push_back(std::move(trace));
}

}  // namespace

void read_joints(const ConfigTable& root, SlopeModel& model) {
    // Traces are read first, because joints of a set may end on them.
    for (const ConfigTable& table : root.array_of_tables("traces")) read_traces(table, model);
    read_joint_sets(root, model);
}

}  // namespace rockslope::blockgen
