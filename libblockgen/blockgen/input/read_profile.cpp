#include "blockgen/input/read_profile.hpp"

#include <algorithm>
#include <cmath>

#include "blockgen/input/csv_table.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/profile.hpp"
#include "blockgen/input/read_dem.hpp"
#include "blockgen/input/read_section.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

constexpr const char* profile_key = "profile_file";

/// A vertex of a profile on the map may lie beside the section line by so much of the line's length; one that
/// is farther belongs to another section.
constexpr double largest_offset = 0.1;
/// From so much of the length on the offset is told.
constexpr double told_offset = 0.01;

/// The line of a profile file, as it is.
struct ProfileLine {
    std::vector<Point> points;
    std::vector<double> heights;     ///< of points of the map
    std::vector<int> lines_of_file;  ///< of each point, in CSV
    MapNotes notes;
};

ProfileLine read_csv_profile(const std::filesystem::path& path) {
    std::vector<std::string> columns = {"distance", "elevation"};
    if (csv_has_column(path, "x")) columns = {"x", "y"};
    if (columns[0] == "x")
        for (const char* height : {"z", "elevation"})
            if (columns.size() < 3 && csv_has_column(path, height)) columns.emplace_back(height);
    CsvTable table = read_csv(path, columns, {});
    ProfileLine line;
    for (std::size_t k = 0; k < table.row_count(); ++k) {
        line.points.push_back({table.number(k, 0), table.number(k, 1)});
        if (columns.size() == 3) line.heights.push_back(table.number(k, 2));
    }
    line.lines_of_file = std::move(table.lines);
    return line;
}

ProfileLine read_vector_profile(const std::filesystem::path& path) {
    MapLines map = read_line_file(path);
    if (map.lines.size() != 1)
        throw InputError({path.string()},
                         "the file has " + std::to_string(map.lines.size()) + " lines, a profile is one",
                         "one line along the ground");
    return {std::move(map.lines[0].points), std::move(map.lines[0].heights), {}, std::move(map.notes)};
}

/// Whether the third coordinates are elevations: drawing programs write zeros where there are none.
bool has_elevations(const ProfileLine& line) {
    return std::any_of(line.heights.begin(), line.heights.end(),
                       [&](double height) { return height != line.heights.front(); });
}

/// Where a point of the profile stands in its file.
SourceLocation place_of(const std::filesystem::path& path, const ProfileLine& line, std::size_t point) {
    SourceLocation place{path.string()};
    if (point < line.lines_of_file.size()) place.line = line.lines_of_file[point];
    return place;
}

void refuse_faults(const std::filesystem::path& path, const ProfileLine& line) {
    const auto fault = find_profile_fault(line.points);
    if (!fault) return;
    const std::string point =
        line.points.size() < 2 ? "" : "point " + std::to_string(fault->point + 1) + ": ";
    throw InputError(place_of(path, line, fault->point), point + fault->what, fault->expected);
}

/// Turns points of the map with heights into distance along the section line and elevation, from its start
/// to its end.
void project(const std::filesystem::path& path, const SectionLine& section, ProfileLine& line,
             SlopeModel& model) {
    double farthest = 0;
    for (std::size_t k = 0; k < line.points.size(); ++k) {
        const Point p = line.points[k];
        const double offset = std::abs(section.across(p));
        if (offset > largest_offset * section.length() || !is_in_allowed_range(line.heights[k]))
            throw InputError(place_of(path, line, k),
                             "point " + std::to_string(k + 1) + " of the profile at " + text_of(p) + " is " +
                                 shortest_text(std::round(offset)) + " m from the section line from " +
                                 text_of(section.from) + " to " + text_of(section.to),
                             "a line along the section line, within a tenth of its length");
        farthest = std::max(farthest, offset);
        line.points[k] = {section.along(p), line.heights[k]};
    }
    if (line.points.front().x > line.points.back().x) {
        std::reverse(line.points.begin(), line.points.end());
        std::reverse(line.lines_of_file.begin(), line.lines_of_file.end());
    }
    if (farthest > told_offset * section.length())
        model.notes.push_back(path.string() + ": the profile is projected to the section line, from " +
                              shortest_text(std::round(10 * farthest) / 10) + " m beside it");
}

std::vector<Point> profile_on_map(const ConfigTable& root, const ConfigTable& domain, ProfileLine line,
                                  SlopeModel& model) {
    const std::filesystem::path& path = model.files.back();
    const SectionLine section = section_line(root, domain, profile_key, model);
    PlacedFile file{domain, profile_key, path, line.notes, {&line.points}, {&line.heights}, true};
    place_coordinates(file, model);
    project(path, section, line, model);
    refuse_faults(path, line);
    std::vector<Point> part = clipped_profile(line.points, 0, section.length());
    if (part.size() < 2)
        throw InputError({path.string()},
                         "the profile lies beyond the ends of the section line, from x = " +
                             shortest_text(line.points.front().x) + " to " +
                             shortest_text(line.points.back().x),
                         "a line between x = 0 and " + shortest_text(section.length()));
    return part;
}

std::vector<Point> profile_in_section(const ConfigTable& domain, ProfileLine line, SlopeModel& model) {
    const std::filesystem::path& path = model.files.back();
    place_in_section({domain, profile_key, path, line.notes, {&line.points}}, model);
    refuse_faults(path, line);
    return std::move(line.points);
}

std::vector<Point> read_line(const ConfigTable& root, const ConfigTable& domain, SlopeModel& model) {
    const std::filesystem::path& path = model.files.back();
    ProfileLine line = is_csv_file(path) ? read_csv_profile(path) : read_vector_profile(path);
    read_section(root, model);
    const bool on_map =
        has_elevations(line) && (is_csv_file(path) || (model.section && model.section->on_map));
    return on_map ? profile_on_map(root, domain, std::move(line), model)
                  : profile_in_section(domain, std::move(line), model);
}

double read_bottom(const ConfigTable& domain, const std::vector<Point>& profile) {
    const double lowest =
        std::min_element(profile.begin(), profile.end(), [](const Point& a, const Point& b) {
            return a.y < b.y;
        })->y;
    if (domain.has("bottom") == domain.has("depth"))
        domain.fail(profile_key, "the section below the profile needs exactly one of bottom and depth",
                    "bottom, an elevation, or depth, a distance below the lowest point of the profile");
    if (domain.has("depth"))
        return lowest - domain.checked(
                            "depth", domain.number("depth", Dimension::length),
                            [](double d) { return d > 0; }, "a positive distance below the lowest point");
    return domain.checked(
        "bottom", domain.number("bottom", Dimension::length), [&](double y) { return y < lowest; },
        "an elevation below " + shortest_text(std::floor(100 * lowest) / 100) +
            " m, the lowest point of the profile");
}

}  // namespace

Ring read_profile(const ConfigTable& root, const ConfigTable& domain, SlopeModel& model) {
    model.files.push_back(domain.file_path(profile_key));
    std::vector<Point> profile = is_geometry_file(model.files.back()) ? read_line(root, domain, model)
                                                                      : read_dem_profile(root, domain, model);
    if (domain.has("simplify"))
        profile = simplified(profile, domain.checked(
                                          "simplify", domain.number("simplify", Dimension::length),
                                          [](double d) { return d >= 0; }, "a distance of zero or more"));
    const double bottom = read_bottom(domain, profile);
    Ring outline = {{profile.front().x, bottom}, {profile.back().x, bottom}};
    outline.insert(outline.end(), profile.rbegin(), profile.rend());
    return outline;
}

}  // namespace rockslope::blockgen
