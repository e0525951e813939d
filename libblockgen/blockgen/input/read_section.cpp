#include "blockgen/input/read_section.hpp"

#include <cmath>
#include <numbers>

#include "blockgen/input/read_shapes.hpp"
#include "common/base/degree.hpp"
#include "common/base/text.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

/// An azimuth that is given beside a line may differ from that of the line by so much: it is often a compass
/// reading in whole degrees. rad
constexpr double azimuth_tolerance = 0.5 * degree;

/// An angle in degrees with one decimal.
std::string degrees_text(double angle) {
    return shortest_text(std::round(10 * angle / degree) / 10) + " deg";
}

SectionLine read_line(const ConfigTable& table) {
    if (!table.has("from") || !table.has("to"))
        table.fail(table.has("from") ? "from" : "to", "a section line of one end",
                   "from = [x, y] and to = [x, y] on the map");
    const SectionLine line{point_of(table.pair("from", Dimension::length)),
                           point_of(table.pair("to", Dimension::length))};
    if (!(line.length() > 0))
        table.fail("to", "the section line has no length: it starts and ends at " + text_of(line.from),
                   "two different points on the map");
    return line;
}

}  // namespace

void read_section(const ConfigTable& root, SlopeModel& model) {
    if (model.section) return;
    const auto table = root.optional_table("section");
    if (!table) return;
    Section section;
    if (table->has("from") || table->has("to")) {
        section.on_map = true;
        section.line = read_line(*table);
        section.azimuth = section.line.azimuth();
        if (table->has("azimuth")) {
            const double given = table->number("azimuth", Dimension::angle);
            if (std::abs(std::remainder(given - section.azimuth, 2 * std::numbers::pi)) > azimuth_tolerance)
                table->fail("azimuth",
                            "the azimuth of " + degrees_text(given) + " is not that of the section line, " +
                                degrees_text(section.azimuth),
                            "the direction from `from` to `to`, clockwise from grid north");
        }
    } else {
        section.azimuth = table->number("azimuth", Dimension::angle);
    }
    model.section = section;
}

const SectionLine& section_line(const ConfigTable& root, const ConfigTable& table, const std::string& key,
                                SlopeModel& model) {
    read_section(root, model);
    if (!model.section || !model.section->on_map)
        table.fail(key, key + " lies on the map, and the model has no section line",
                   "[section] with from = [x, y] and to = [x, y]");
    return model.section->line;
}

}  // namespace rockslope::blockgen
