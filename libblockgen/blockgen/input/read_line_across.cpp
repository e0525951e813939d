#include <algorithm>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/height_line.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/read_geology.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

std::vector<Point> read_points(const ConfigTable& table, const std::string& key, SlopeModel& model) {
    const std::string file_key = key + "_file";
    if (table.has(key) == table.has(file_key))
        table.fail(table.has(key) ? file_key : "",
                   "'" + key + "' and '" + file_key + "' in [" + table.path() + "] are " +
                       (table.has(key) ? "both given" : "missing"),
                   "one of them");
    std::vector<Point> points;
    if (table.has(key)) {
        for (const auto& pair : table.pairs(key, Dimension::length)) points.push_back(point_of(pair));
    } else {
        model.files.push_back(table.file_path(file_key));
        PlacedFile file{table, file_key, model.files.back(), {}, {}};
        points = read_single_line(file.path, &file.notes);
        file.lines.push_back(&points);
        place_coordinates(file, model);
    }
    return points;
}

/// @throws InputError for a line that lies beside the domain: its coordinates are others.
void refuse_line_elsewhere(const ConfigTable& table, const std::string& key, const std::vector<Point>& points,
                           const SlopeModel& model) {
    const Bounds box = domain_bounds(model);
    if (points.size() == 1 || (points.front().x < box.high.x && points.back().x > box.low.x)) return;
    table.fail(key,
               "the line from " + text_of(points.front()) + " to " + text_of(points.back()) +
                   " lies beside the domain, from " + text_of(box.low) + " to " + text_of(box.high),
               "a line in the coordinates of the domain");
}

}  // namespace

std::vector<Point> read_line_across(const ConfigTable& table, const std::string& key,
                                    const std::string& expected, SlopeModel& model) {
    std::vector<Point> points = read_points(table, key, model);
    const std::string given = table.has(key) ? key : key + "_file";
    if (points.empty()) table.fail(given, "a line without a point", "one point or more, [[x, y], ...]");
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.front().x > points.back().x) std::reverse(points.begin(), points.end());
    if (const auto turn = first_turn_back(points))
        table.fail(given, "the line turns back before " + text_of(*turn), expected);
    if (points.size() > 1 && points.front().x == points.back().x)
        table.fail(given, "the line is upright at " + text_of(points.front()), expected);
    refuse_line_elsewhere(table, given, points, model);
    check_coordinate_range(table, given, points, model);
    return points;
}

void add_region(const ConfigTable& table, Region region, SlopeModel& model) {
    for (const Region& other : model.regions)
        if (other.name == region.name)
            table.fail("name", std::string("a second ") + other.kind + " '" + region.name + "'",
                       "a name for each region, layer and weathered zone");
    model.regions.push_back(std::move(region));
}

}  // namespace rockslope::blockgen
