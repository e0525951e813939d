#include "blockgen/input/place_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/length_unit.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

/// The word for coordinates of no reference system, in metres.
constexpr const char* local = "local";

constexpr const char* remedy =
    "metres: project = \"EPSG:...\" in [domain] converts, crs = \"local\" says that these are metres";

Bounds bounds_of(const PlacedFile& file) {
    Ring all;
    for (const std::vector<Point>* line : file.lines) all.insert(all.end(), line->begin(), line->end());
    return Bounds::of(all);
}

bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Whether points look like longitudes and latitudes: they could be, and they lie farther from the origin
/// than they are wide. A section in metres begins near its origin, or in a national grid of thousands of
/// metres. What lies in the domain is in its coordinates, whatever these are.
bool look_like_degrees(const Bounds& bounds, const std::optional<Bounds>& domain) {
    if (bounds.low.x < -180 || bounds.high.x > 180 || bounds.low.y < -90 || bounds.high.y > 90) return false;
    if (domain && overlap(bounds, *domain)) return false;
    const Point nearest = bounds.nearest({0, 0});
    return std::hypot(nearest.x, nearest.y) >
           std::hypot(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
}

[[noreturn]] void fail(const PlacedFile& file, const std::string& what, const std::string& expected) {
    file.table.fail(file.key, file.path.string() + ": " + what, expected);
}

/// Notes the same thing of an outline file and of a file of traces once each.
void add_note(const PlacedFile& file, const std::string& what, SlopeModel& model) {
    model.notes.push_back(file.path.string() + ": " + what);
}

void note_what_was_left_out(const PlacedFile& file, SlopeModel& model) {
    if (file.notes.empty > 0)
        add_note(file, std::to_string(file.notes.empty) + " empty geometries are skipped", model);
    if (file.notes.with_heights > 0 && !file.on_map)
        add_note(file,
                 "the third coordinate of " + std::to_string(file.notes.with_heights) +
                     " geometries is ignored: x and y are the axes of the section",
                 model);
}

/// Scales the points of a file whose unit is stated.
void scale(const PlacedFile& file, SlopeModel& model) {
    const std::string stated = file.table.string("unit", "");
    const std::string& unit = stated.empty() ? file.notes.unit : stated;
    if (unit.empty()) return;
    const std::optional<double> metres = metres_in(unit);
    if (!metres)
        file.table.fail(stated.empty() ? file.key : "unit", "the unit '" + unit + "' is not a length of maps",
                        "unit = one of " + length_unit_words());
    if (*metres == 1) return;
    for (std::vector<Point>* line : file.lines)
        for (Point& p : *line) p = {p.x * *metres, p.y * *metres};
    for (std::vector<double>* heights : file.heights)
        for (double& height : *heights) height *= *metres;
    if (stated.empty())
        add_note(file,
                 "the drawing is in " + unit +
                     ", as it states ($INSUNITS), and is converted to metres; unit = "
                     "\"m\" in the model file says otherwise",
                 model);
}

/// The system of a file: that of the model file, that of the file itself, or degrees where the coordinates
/// look like them.
CoordinateSystem system_of(const PlacedFile& file, const std::string& crs, const SlopeModel& model) {
    if (crs == local) return {};
    const SourceLocation place = crs.empty() ? SourceLocation{file.path.string()} : file.table.place("crs");
    const std::string& text = crs.empty() ? file.notes.system : crs;
    if (!text.empty()) return CoordinateSystem(text, place);
    const bool has_domain = !file.on_map && !model.outline.empty();
    if (!look_like_degrees(bounds_of(file), has_domain ? std::optional(domain_bounds(model)) : std::nullopt))
        return {};
    if (!model.project.exists()) fail(file, "the coordinates state no system and look like degrees", remedy);
    return CoordinateSystem("OGC:CRS84", place);
}

void refuse_other_units(const PlacedFile& file, const CoordinateSystem& system) {
    if (system.is_in_degrees()) fail(file, "the coordinates are in degrees: " + system.name(), remedy);
    if (system.metres_per_unit() != 1)
        fail(file, "a unit of " + system.name() + " is " + shortest_text(system.metres_per_unit()) + " m",
             remedy);
}

/// Without `project`: the system must be in metres and that of the files before.
void adopt(const PlacedFile& file, const CoordinateSystem& system, SlopeModel& model) {
    refuse_other_units(file, system);
    if (!model.system.exists()) {
        model.system = system;
        model.system_file = file.path.string();
    } else if (!model.system.is_same(system)) {
        fail(file,
             "the coordinates are in " + system.name() + ", but those of " + model.system_file + " in " +
                 model.system.name(),
             "one system, or project = \"EPSG:...\" in [domain] to convert to");
    }
}

/// Scales third coordinates whose unit the vertical part of the system states.
void scale_heights(const PlacedFile& file, const CoordinateSystem& system, SlopeModel& model) {
    if (file.heights.empty()) return;
    if (!system.states_heights() && !system.is_in_degrees() && system.metres_per_unit() != 1)
        fail(file,
             "a unit of " + system.name() + " is " + shortest_text(system.metres_per_unit()) +
                 " m, and the unit of the third coordinates is not stated",
             "crs with a vertical system, such as \"EPSG:2263+6360\"");
    if (system.metres_per_height_unit() == 1) return;
    for (std::vector<double>* heights : file.heights)
        for (double& height : *heights) height *= system.metres_per_height_unit();
    add_note(file,
             "the third coordinates are in units of " + shortest_text(system.metres_per_height_unit()) +
                 " m, as their system states, and are converted to metres",
             model);
}

}  // namespace

void read_project(const ConfigTable& domain, SlopeModel& model) {
    const std::string text = domain.string("project", "");
    if (text.empty()) return;
    model.project = CoordinateSystem(text, domain.place("project"));
    if (model.project.is_in_degrees() || model.project.metres_per_unit() != 1)
        domain.fail("project", model.project.name() + " is not in metres",
                    "a projected system in metres, such as \"EPSG:32634\"");
}

void place_in_section(const PlacedFile& file, SlopeModel& model) {
    note_what_was_left_out(file, model);
    const std::string crs = file.table.string("crs", "");
    scale(file, model);
    const std::string& system = crs.empty() ? file.notes.system : crs;
    if (!system.empty() && system != local)
        fail(file,
             "the coordinates are in " + CoordinateSystem(system, SourceLocation{file.path.string()}).name() +
                 ", but x and y of a profile are distance and elevation",
             "crs = \"local\", or a line with third coordinates along [section] from and to");
}

CoordinateSystem accepted_system(const PlacedFile& file, SlopeModel& model) {
    CoordinateSystem system = system_of(file, file.table.string("crs", ""), model);
    if (system.exists() && !model.project.exists()) adopt(file, system, model);
    return system;
}

void place_coordinates(const PlacedFile& file, SlopeModel& model) {
    note_what_was_left_out(file, model);
    file.table.string("crs", "");  // read before `unit`, in the order of the effective text
    scale(file, model);
    const CoordinateSystem system = accepted_system(file, model);
    if (!system.exists()) return;
    scale_heights(file, system, model);
    if (!model.project.exists() || system.is_same(model.project)) return;
    for (std::vector<Point>* line : file.lines) system.convert(*line, model.project, {file.path.string()});
    add_note(file, "converted from " + system.name() + " to " + model.project.name(), model);
}

}  // namespace rockslope::blockgen
