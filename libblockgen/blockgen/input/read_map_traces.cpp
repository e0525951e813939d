#include "blockgen/input/read_map_traces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/meet_section.hpp"
#include "blockgen/input/out_of_plane.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/read_section.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

/// From this difference on, m, elevations of traces that cross the section line are told to differ from the
/// ground: a metre is more than a survey errs.
constexpr double told_difference = 1;

/// From this angle on, rad, traces that leave the plane of their dip and dip direction are told: a strike
/// given as dip direction exceeds it where a plane dips by more, and ground that slopes by less does not.
constexpr double told_angle = std::numbers::pi / 6;

/// What the table asks for, of all its traces.
struct Projection {
    const ConfigTable& table;
    std::string source;  ///< the file, or the table
    std::string name, joint_material;
    std::optional<double> dip = {}, dip_direction = {};  ///< rad
    double reach = 0;                                    ///< m
    std::optional<double> length = {};                   ///< m, to each side of the outcrop
    bool takes_own_elevation = false;
};

/// What became of the traces.
struct Tally {
    std::array<std::size_t, 5> met{};  ///< by Meeting
    std::size_t several = 0, off_ground = 0;
    double nearest = 0;     ///< extension of the nearest trace that is too far, m
    double difference = 0;  ///< largest between the elevations of a trace and of the ground, m
    std::size_t out_of_plane = 0, of_level_ground = 0;  ///< the latter of them without elevations
    Point first_out_of_plane;

    std::size_t of(Meeting how) const { return met[static_cast<std::size_t>(how)]; }
    std::size_t projected() const { return of(Meeting::crosses) + of(Meeting::extended) - off_ground; }
};

std::optional<double> optional_angle(const ConfigTable& table, const char* key) {
    return table.has(key) ? std::optional(table.number(key, Dimension::angle)) : std::nullopt;
}

constexpr const char* dip_expected = "a dip from 0 to 90 deg";

bool is_dip(double dip) {
    return dip >= 0 && dip <= std::numbers::pi / 2 + 1e-12;
}

Projection read_projection(const ConfigTable& table, const std::string& name, const std::string& material) {
    Projection wanted{table, "[[traces]] '" + name + "'", name, material};
    wanted.dip = optional_angle(table, "dip");
    if (wanted.dip) table.checked("dip", *wanted.dip, is_dip, dip_expected);
    wanted.dip_direction = optional_angle(table, "dip_direction");
    wanted.reach = table.checked(
        "reach", table.number("reach", Dimension::length, 0.0), [](double d) { return d >= 0; },
        "a distance of zero or more");
    if (table.has("trace_length"))
        wanted.length = table.checked(
            "trace_length", table.number("trace_length", Dimension::length), [](double d) { return d > 0; },
            "a positive length");
    wanted.takes_own_elevation = table.choice("elevation", {"ground", "trace"}, "ground") == "trace";
    return wanted;
}

/// The lines of the table on the map, in metres.
MapLines read_lines(Projection& wanted, SlopeModel& model) {
    const ConfigTable& table = wanted.table;
    MapLines map;
    if (table.has("points")) {
        map.lines.emplace_back();
        for (const auto& pair : table.pairs("points", Dimension::length))
            map.lines[0].points.push_back(point_of(pair));
        if (map.lines[0].points.size() < 2)
            table.fail("points", "a trace of fewer than two points", "two points or more");
        return map;
    }
    model.files.push_back(table.file_path("file"));
    wanted.source = model.files.back().string();
    map = read_line_file(model.files.back(), LineFields::all);
    PlacedFile file{table, "file", model.files.back(), map.notes, {}, {}, true};
    for (MapLine& line : map.lines) {
        file.lines.push_back(&line.points);
        if (!line.heights.empty()) file.heights.push_back(&line.heights);
    }
    if (file.lines.empty())
        throw InputError({wanted.source}, "the file contains no trace", "one trace or more");
    place_coordinates(file, model);
    if (map.notes.with_heights > 0 && !wanted.takes_own_elevation)
        model.notes.push_back(wanted.source + ": third coordinates of " +
                              std::to_string(map.notes.with_heights) +
                              " geometries are not used: elevation = \"trace\" takes them");
    return map;
}

/// One angle of a trace: from its field in the file, in degrees, or from the table.
double angle_of(const Projection& wanted, std::size_t number, const std::optional<double>& field,
                const std::optional<double>& of_table, const std::string& key) {
    if (field) return *field * std::numbers::pi / 180;
    if (of_table) return *of_table;
    wanted.table.fail(wanted.table.has("file") ? "file" : "points",
                      wanted.source + ": trace " + std::to_string(number + 1) + " has no " + key,
                      key + " in the table, or a field " + key + " of the file, in degrees");
}

JointPlane plane_of(const Projection& wanted, std::size_t number, const MapLine& line) {
    const JointPlane plane{
        angle_of(wanted, number, line.plane.dip, wanted.dip, "dip"),
        angle_of(wanted, number, line.plane.dip_direction, wanted.dip_direction, "dip_direction")};
    if (!is_dip(plane.dip))
        throw InputError({wanted.source},
                         "trace " + std::to_string(number + 1) + " has a dip of " +
                             shortest_text(*line.plane.dip) + " degrees",
                         dip_expected);
    return plane;
}

/// Elevation of the joint where it meets the section line; nothing where the section has no ground.
std::optional<double> elevation_of(const Projection& wanted, std::size_t number, const MapLine& line,
                                   const Outcrop& outcrop, const VerticalSections& outlines, Tally& tally) {
    const std::optional<double> ground = outlines.at(outcrop.x).top;
    if (!wanted.takes_own_elevation || !ground) return ground;
    if (!outcrop.elevation || !is_in_allowed_range(*outcrop.elevation))
        wanted.table.fail("elevation",
                          wanted.source + ": trace " + std::to_string(number + 1) + " at " +
                              text_of(line.points[0]) + " has no elevation",
                          "traces with third coordinates, or elevation = \"ground\"");
    if (outcrop.how == Meeting::crosses)
        tally.difference = std::max(tally.difference, std::abs(*outcrop.elevation - *ground));
    return outcrop.elevation;
}

void check_direction(const MapLine& line, const JointPlane& plane, Tally& tally) {
    const bool has_heights = !line.heights.empty() && is_in_allowed_range(line.heights.front()) &&
                             is_in_allowed_range(line.heights.back());
    const std::span<const double> heights = line.heights;
    if (!(angle_out_of_plane(line.points, has_heights ? heights : heights.first(0), plane) > told_angle))
        return;
    if (++tally.out_of_plane == 1) tally.first_out_of_plane = line.points.front();
    tally.of_level_ground += !has_heights;
}

/// The line at the apparent dip through a point, through the whole domain or of the given length to each
/// side. Fewer than two points when it misses the domain.
std::vector<Point> joint_through(const Point& p, double angle, const std::optional<double>& length,
                                 const Bounds& box) {
    const Point direction{std::cos(angle), std::sin(angle)};
    const auto clipped =
        box.expanded(0.01 * std::max(box.high.x - box.low.x, box.high.y - box.low.y)).clip(p, direction);
    if (!clipped) return {};
    const auto at = [&](double t) { return Point{p.x + t * direction.x, p.y + t * direction.y}; };
    if (length) return {at(-*length), at(*length)};
    return {at(clipped->first), at(clipped->second)};
}

std::string rounded(double metres) {
    return shortest_text(std::round(10 * metres) / 10);
}

/// What became of the traces that are not projected, for a note or an error; empty when all are.
std::string left_out(const Tally& tally, const Projection& wanted) {
    std::string text;
    const auto add = [&text](std::size_t count, const std::string& what) {
        if (count > 0) text += (text.empty() ? "" : "; ") + std::to_string(count) + " " + what;
    };
    add(tally.of(Meeting::too_far),
        "farther along strike from the section line than reach = " + shortest_text(wanted.reach) +
            " m, the nearest " + rounded(tally.nearest) + " m");
    add(tally.of(Meeting::beyond_ends), "meeting it beyond its ends");
    add(tally.of(Meeting::parallel), "parallel to the section");
    add(tally.off_ground, "where the section has no ground, or too far above or below it");
    return text;
}

/// What is told of traces that leave their plane.
std::string out_of_plane_text(const Tally& tally) {
    const bool is_one = tally.out_of_plane == 1;
    std::string text = std::to_string(tally.out_of_plane) +
                       (is_one ? " mapped trace runs" : " mapped traces run") + " more than " +
                       shortest_text(std::round(told_angle * 180 / std::numbers::pi)) +
                       " deg out of the plane of " + (is_one ? "its" : "their") +
                       " dip and dip direction, the first at " + text_of(tally.first_out_of_plane);
    if (tally.of_level_ground == 0) return text + ", by their elevations";
    if (tally.of_level_ground < tally.out_of_plane)
        text += "; of " + std::to_string(tally.of_level_ground) + " without elevations";
    else
        text += "; without elevations";
    return text + " the ground is taken as level, where a trace follows the strike";
}

void note_tally(const Tally& tally, const Projection& wanted, std::size_t all, SlopeModel& model) {
    const std::string text = left_out(tally, wanted);
    if (tally.projected() == 0)
        wanted.table.fail(wanted.table.has("file") ? "file" : "points",
                          wanted.source + ": no trace meets the section: " + text,
                          "traces on the map across [section] from and to, or a larger reach");
    const auto note = [&](const std::string& what) { model.notes.push_back(wanted.source + ": " + what); };
    if (!text.empty())
        note(std::to_string(tally.projected()) + " of " + std::to_string(all) +
             " mapped traces are projected to the section; left out are " + text);
    if (tally.several > 0)
        note(std::to_string(tally.several) +
             " mapped traces cross the section line more than once; the first crossing counts");
    if (tally.out_of_plane > 0) note(out_of_plane_text(tally));
    if (tally.difference > told_difference)
        note("elevations of the mapped traces differ from the ground by up to " + rounded(tally.difference) +
             " m at the section line");
}

}  // namespace

void read_map_traces(const ConfigTable& root, const ConfigTable& table, const std::string& name,
                     const std::string& joint_material, SlopeModel& model) {
    const SectionLine section = section_line(root, table, "on", model);
    Projection wanted = read_projection(table, name, joint_material);
    const MapLines map = read_lines(wanted, model);
    const VerticalSections outlines = outline_sections(model);
    const Bounds box = domain_bounds(model);
    Tally tally;
    Ring reached;  // all points of the joints
    for (std::size_t k = 0; k < map.lines.size(); ++k) {
        const MapLine& line = map.lines[k];
        const JointPlane plane = plane_of(wanted, k, line);
        const Outcrop outcrop = meet_section(section, line.points, line.heights, plane, wanted.reach);
        ++tally.met[static_cast<std::size_t>(outcrop.how)];
        if (outcrop.how == Meeting::too_far)
            tally.nearest = tally.of(Meeting::too_far) == 1 ? outcrop.distance
                                                            : std::min(tally.nearest, outcrop.distance);
        if (outcrop.how != Meeting::crosses && outcrop.how != Meeting::extended) continue;
        tally.several += outcrop.crosses_again;
        const auto elevation = elevation_of(wanted, k, line, outcrop, outlines, tally);
        std::vector<Point> points;
        if (elevation)
            points = joint_through({outcrop.x, *elevation}, apparent_angle(plane, section.azimuth()),
                                   wanted.length, box);
        if (points.empty()) {
            ++tally.off_ground;
            continue;
        }
        check_direction(line, plane, tally);
        reached.insert(reached.end(), points.begin(), points.end());
        model.traces.push_back(
            {wanted.name, joint_material_of(line, wanted.joint_material, wanted.source), std::move(points)});
    }
    check_coordinate_range(table, table.has("file") ? "file" : "points", reached, model);
    note_tally(tally, wanted, map.lines.size(), model);
}

}  // namespace rockslope::blockgen
