#include "blockgen/fit/read_joint_map.hpp"

#include <utility>

#include "blockgen/input/geojson.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/repeated_traces.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

namespace {

std::string toml_text(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

/// The keys of a slope model that say what coordinates mean.
ConfigTable table_of(const MapRequest& request) {
    std::string text;
    const auto add = [&text](const char* key, const std::string& value) {
        if (!value.empty()) text += std::string(key) + " = " + toml_text(value) + "\n";
    };
    add("file", request.traces.string());
    add("crs", request.crs);
    add("unit", request.unit);
    add("project", request.project);
    return ConfigTable::from_text(text, request.traces.string());
}

bool is_geojson(const std::filesystem::path& path) {
    return path.extension() == ".geojson" || path.extension() == ".json";
}

/// The files as they are.
struct RawMap {
    std::vector<Trace> traces;
    MapNotes trace_notes, outline_notes;
    std::vector<std::vector<Ring>> polygons;
};

void open_ring(Ring& ring) {
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

RawMap read_files(const MapRequest& request) {
    RawMap raw;
    if (is_geojson(request.traces)) {
        GeoJsonMap map = read_geojson_map(request.traces);
        for (MapLine& line : map.lines.lines)
            raw.traces.push_back({"joints", "joints", std::move(line.points)});
        raw.trace_notes = map.lines.notes;
        raw.outline_notes.system = map.lines.notes.system;
        raw.polygons = std::move(map.polygons.polygons);
        for (std::vector<Ring>& rings : raw.polygons)
            for (Ring& ring : rings) open_ring(ring);
    } else {
        raw.traces = read_trace_file(request.traces, "joints", "joints", &raw.trace_notes);
    }
    if (raw.traces.empty())
        throw InputError({request.traces.string()}, "the file contains no trace", "one trace or more");
    if (!request.outline.empty()) {
        raw.outline_notes = {};
        raw.polygons = read_outline_file(request.outline, &raw.outline_notes);
    }
    return raw;
}

void take_box_of_traces(JointMapFile& file) {
    Ring all;
    for (const Trace& trace : file.map.traces)
        all.insert(all.end(), trace.points.begin(), trace.points.end());
    const Bounds box = Bounds::of(all);
    file.map.window.outer = {
        {{box.low.x, box.low.y}, {box.high.x, box.low.y}, {box.high.x, box.high.y}, {box.low.x, box.high.y}}};
    file.notes.emplace_back(
        "the mapped area is taken to be the box around the traces: --outline names the file of its outline");
}

}  // namespace

JointMapFile read_joint_map(const MapRequest& request) {
    const ConfigTable table = table_of(request);
    SlopeModel model;
    read_project(table, model);
    RawMap raw = read_files(request);
    PlacedFile traces{table, "file", request.traces, raw.trace_notes, {}};
    for (Trace& trace : raw.traces) traces.lines.push_back(&trace.points);
    place_coordinates(traces, model);
    // A trace that was digitised twice is one joint.
    model.traces = std::move(raw.traces);
    drop_repeated_traces(model);
    JointMapFile file;
    file.map.traces = std::move(model.traces);
    if (raw.polygons.empty()) {
        take_box_of_traces(file);
    } else {
        const std::filesystem::path& path = request.outline.empty() ? request.traces : request.outline;
        PlacedFile outline{table, "file", path, raw.outline_notes, {}};
        for (std::vector<Ring>& rings : raw.polygons)
            for (Ring& ring : rings) outline.lines.push_back(&ring);
        place_coordinates(outline, model);
        for (std::vector<Ring>& rings : raw.polygons)
            for (std::size_t k = 0; k < rings.size(); ++k)
                (k == 0 ? file.map.window.outer : file.map.window.holes).push_back(std::move(rings[k]));
    }
    file.notes.insert(file.notes.begin(), model.notes.begin(), model.notes.end());
    if (!(file.map.window.area() > 0))
        throw InputError({request.traces.string()}, "the mapped area is empty", "traces that span an area");
    return file;
}

}  // namespace rockslope::blockgen
