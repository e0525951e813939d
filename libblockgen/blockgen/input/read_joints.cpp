#include "blockgen/input/domain.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/join_ends.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/read_map_traces.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "blockgen/input/repeated_traces.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

/// @throws InputError when none of the traces meets the bounding box of the domain.
void refuse_traces_elsewhere(const PlacedFile& file, const SlopeModel& model) {
    Ring all;
    const Bounds domain = domain_bounds(model);
    for (const std::vector<Point>* line : file.lines) {
        const Bounds bounds = Bounds::of(*line);
        if (bounds.low.x <= domain.high.x && domain.low.x <= bounds.high.x && bounds.low.y <= domain.high.y &&
            domain.low.y <= bounds.high.y)
            return;
        all.insert(all.end(), line->begin(), line->end());
    }
    const auto text = [](const Bounds& box) { return text_of(box.low) + " to " + text_of(box.high); };
    file.table.fail(file.key,
                    "no trace of " + file.path.string() + " is near the domain: they lie in " +
                        text(Bounds::of(all)) + ", the domain in " + text(domain),
                    "traces in the coordinates of the domain");
}

void read_file_of_traces(const ConfigTable& table, const std::string& name, const std::string& material,
                         SlopeModel& model) {
    model.files.push_back(table.file_path("file"));
    PlacedFile file{table, "file", model.files.back(), {}, {}};
    std::vector<Trace> traces = read_trace_file(file.path, name, material, &file.notes);
    for (Trace& trace : traces) file.lines.push_back(&trace.points);
    place_coordinates(file, model);
    refuse_traces_elsewhere(file, model);
    for (Trace& trace : traces) {
        check_coordinate_range(table, "file", trace.points, model);
        model.traces.push_back(std::move(trace));
    }
}

void read_traces(const ConfigTable& root, const ConfigTable& table, SlopeModel& model) {
    const std::string fallback = "traces " + std::to_string(model.traces.size() + 1);
    const std::string material = table.string("joint_material", "");
    const std::string name = table.string("name", material.empty() ? fallback : material);
    if (table.has("points") == table.has("file"))
        table.fail("points", "traces need points or a file", "exactly one of them");
    if (table.has("on") && table.choice("on", {"section", "map"}) == "map") {
        read_map_traces(root, table, name, material, model);
        return;
    }
    if (table.has("file")) {
        read_file_of_traces(table, name, material, model);
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
    for (const ConfigTable& table : root.array_of_tables("traces")) read_traces(root, table, model);
    const ConfigTable domain = root.table("domain");
    const double snap = domain.checked(
        "snap", domain.number("snap", Dimension::length, 0.0), [](double d) { return d >= 0; },
        "a distance of zero or more");
    if (!model.outline_of_traces) drop_repeated_traces(model);
    if (!model.outline_of_traces) join_ends(snap, model);
    read_joint_sets(root, model);
}

}  // namespace rockslope::blockgen
