#include <algorithm>
#include <bit>
#include <cstdint>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/join_ends.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/read_map_traces.hpp"
#include "blockgen/input/read_shapes.hpp"

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

/// Whether two traces have the same points, in the same direction or in opposite ones.
bool are_same(const std::vector<Point>& a, const std::vector<Point>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end()) ||
           std::equal(a.begin(), a.end(), b.rbegin(), b.rend());
}

/// A hash of a trace's ends that does not depend on its direction, for a table of a power of two.
std::size_t hash_of(const std::vector<Point>& points) {
    const auto hash = [](const Point& p) {
        // -0 equals 0.
        const std::uint64_t x = std::bit_cast<std::uint64_t>(p.x + 0.0),
                            y = std::bit_cast<std::uint64_t>(p.y + 0.0);
        std::uint64_t bits = (x ^ (x >> 32u)) * 0x9e3779b97f4a7c15u ^ (y ^ (y >> 29u)) * 0xc2b2ae3d27d4eb4fu;
        bits = (bits ^ (bits >> 31u)) * 0x94d049bb133111ebu;
        return bits ^ (bits >> 30u);
    };
    return hash(points.front()) + hash(points.back());
}

/// Removes traces that repeat an earlier one, in either direction, and notes how many: their lengths would be
/// counted twice.
void drop_repeated_traces(SlopeModel& model) {
    constexpr std::uint32_t vacant = 0xffffffffu;
    const std::vector<Trace>& traces = model.traces;
    // Open addressing in a table at most half full.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * traces.size() + 2), vacant);
    std::vector<char> is_repeated(traces.size(), 0);
    const Trace* first = nullptr;
    std::size_t repeated = 0;
    for (std::size_t t = 0; t < traces.size(); ++t) {
        std::size_t place = hash_of(traces[t].points) & (table.size() - 1);
        while (table[place] != vacant && !are_same(traces[table[place]].points, traces[t].points))
            place = (place + 1) & (table.size() - 1);
        if (table[place] == vacant) {
            table[place] = static_cast<std::uint32_t>(t);
            continue;
        }
        is_repeated[t] = 1;
        ++repeated;
        if (first == nullptr) first = &traces[t];
    }
    if (repeated == 0) return;
    model.notes.push_back(std::to_string(repeated) +
                          (repeated == 1 ? " trace repeats an earlier one" : " traces repeat earlier ones") +
                          " and " + (repeated == 1 ? "is" : "are") + " dropped, the first of '" +
                          first->name + "' at " + text_of(first->points.front()));
    std::vector<Trace> kept;
    for (std::size_t t = 0; t < model.traces.size(); ++t)
        if (!is_repeated[t]) kept.push_back(std::move(model.traces[t]));
    model.traces = std::move(kept);
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
