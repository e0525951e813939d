#include "blockgen/input/read_dem.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "blockgen/input/elevation_raster.hpp"
#include "blockgen/input/length_unit.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/read_section.hpp"
#include "common/base/text.hpp"
#include "common/geometry/clip_line.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

constexpr const char* dem_key = "profile_file";

/// Largest number of points of a profile: as many blocks as a model has at most by default.
constexpr double max_profile_points = 1e6;

/// A raster of elevations and how the model's coordinates lead into it.
struct Dem {
    const ConfigTable& domain;
    const std::filesystem::path& path;
    ElevationRaster raster;
    CoordinateSystem system;       ///< of the raster, where one is known
    CoordinateSystem line_system;  ///< of the section line, where it is another one
    double metres_per_unit = 1;    ///< of the elevations
};

/// Points of the section line in the raster's coordinates.
std::vector<Point> in_raster(const Dem& dem, std::vector<Point> points) {
    if (dem.line_system.exists()) dem.line_system.convert(points, dem.system, {dem.path.string()});
    return points;
}

/// Metres in the unit of the elevations: `unit` of the table, or that of the band, or that of the vertical
/// part of the raster's system.
double elevation_unit(const Dem& dem, SlopeModel& model) {
    const std::string stated = dem.domain.string("unit", "");
    const std::string word = stated.empty() ? length_unit_word(dem.raster.unit()) : stated;
    if (word.empty() && !dem.system.states_heights() && !dem.system.is_in_degrees() &&
        dem.system.metres_per_unit() != 1)
        dem.domain.fail(dem_key,
                        dem.path.string() + ": a unit of " + dem.system.name() + " is " +
                            shortest_text(dem.system.metres_per_unit()) +
                            " m, and the unit of the elevations is not stated",
                        "unit = \"ft\", \"us-ft\" or \"m\" for the elevations");
    const std::optional<double> metres =
        word.empty() ? std::optional(dem.system.metres_per_height_unit()) : metres_in(word);
    if (!metres)
        dem.domain.fail(stated.empty() ? dem_key : "unit",
                        "the unit '" + word + "' of the elevations in " + dem.path.string() + " is no length",
                        "unit = one of " + length_unit_words());
    if (*metres != 1 && stated.empty())
        model.notes.push_back(
            dem.path.string() + ": the elevations are in units of " + shortest_text(*metres) +
            " m, as the file states, and are converted to metres; unit = \"m\" in the model "
            "file says otherwise");
    return *metres;
}

Dem opened_dem(const ConfigTable& domain, SlopeModel& model) {
    const std::filesystem::path& path = model.files.back();
    Dem dem{domain, path, ElevationRaster(path), {}, {}, 1};
    std::vector<Point> corners = dem.raster.corners();
    MapNotes notes;
    notes.system = dem.raster.system();
    dem.system = accepted_system({domain, dem_key, path, notes, {&corners}, {}, true}, model);
    if (dem.system.exists() && model.project.exists() && !dem.system.is_same(model.project))
        dem.line_system = model.project;
    dem.metres_per_unit = elevation_unit(dem, model);
    return dem;
}

/// Number of equal steps along the section line.
std::size_t number_of_steps(const Dem& dem, const SectionLine& line) {
    const std::vector<Point> ends = in_raster(dem, {line.from, line.to});
    const Point first = dem.raster.cell_of(ends[0]), last = dem.raster.cell_of(ends[1]);
    double steps = std::hypot(last.x - first.x, last.y - first.y);
    if (dem.domain.has("profile_step"))
        steps = line.length() / dem.domain.checked(
                                    "profile_step", dem.domain.number("profile_step", Dimension::length),
                                    [](double s) { return s > 0; }, "a positive distance");
    if (!(steps < max_profile_points))
        dem.domain.fail(dem.domain.has("profile_step") ? "profile_step" : dem_key,
                        "the profile along the section line would have " +
                            std::to_string(static_cast<std::int64_t>(std::min(steps, 1e18))) + " points",
                        "a profile_step that makes less than a million");
    // A line that is a whole number of steps long does not get another one by rounding.
    return static_cast<std::size_t>(std::max(1.0, std::ceil(steps - 1e-6)));
}

/// "(x, y)" to six decimals, a micrometre or a tenth of a metre in degrees.
std::string rounded_text(const Point& p) {
    return text_of({std::round(1e6 * p.x) / 1e6, std::round(1e6 * p.y) / 1e6});
}

[[noreturn]] void refuse_line_outside(const Dem& dem, const SectionLine& line) {
    const std::vector<Point> ends = in_raster(dem, {line.from, line.to});
    const Bounds covered = Bounds::of(dem.raster.corners());
    throw InputError(dem.domain.place(dem_key),
                     "the section line leaves the raster " + dem.path.string() + ": it runs from " +
                         rounded_text(ends[0]) + " to " + rounded_text(ends[1]) + ", the raster from " +
                         rounded_text(covered.low) + " to " + rounded_text(covered.high) +
                         (dem.line_system.exists() ? ", in " + dem.system.name() : ""),
                     "[section] from and to within the raster");
}

}  // namespace

std::vector<Point> read_dem_profile(const ConfigTable& root, const ConfigTable& domain, SlopeModel& model) {
    const SectionLine line = section_line(root, domain, dem_key, model);
    const Dem dem = opened_dem(domain, model);
    const std::size_t steps = number_of_steps(dem, line);
    std::vector<Point> profile(steps + 1), map_points(steps + 1);
    for (std::size_t k = 0; k <= steps; ++k) {
        profile[k].x = line.length() * (static_cast<double>(k) / static_cast<double>(steps));
        map_points[k] = k < steps ? line.at(profile[k].x) : line.to;
    }
    const std::vector<Point> places = in_raster(dem, map_points);
    for (const Point& p : places)
        if (!dem.raster.contains(p)) refuse_line_outside(dem, line);
    for (std::size_t k = 0; k <= steps; ++k) {
        const std::optional<double> elevation = dem.raster.elevation_at(places[k]);
        if (!elevation)
            throw InputError({dem.path.string()},
                             "the raster has no elevation at " + rounded_text(map_points[k]) + ", " +
                                 shortest_text(std::round(100 * profile[k].x) / 100) +
                                 " m along the section line",
                             "elevations along the whole section line");
        profile[k].y = *elevation * dem.metres_per_unit;
    }
    return profile;
}

}  // namespace rockslope::blockgen
