#include "blockgen/input/geo_file.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "common/base/text.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

std::string numbered(const std::string& word, std::size_t k) {
    return word + " " + std::to_string(k + 1);
}

/// Adds the outline, which encloses the area of the lines, and a cavity for each face with a hole point.
void add_rock(const ConfigTable& domain, const GeoFile& geo, const EnclosedAreaFunction& enclosed_area,
              SlopeModel& model) {
    std::vector<std::pair<Point, Point>> lines;
    Ring ends;
    for (const GeoLine& line : geo.joints) {
        lines.emplace_back(line.a, line.b);
        ends.push_back(line.a);
        ends.push_back(line.b);
    }
    if (lines.empty()) domain.fail("geo_file", "the file contains no lines", "lines that enclose blocks");
    check_coordinate_range(domain, "geo_file", ends, model);
    const EnclosedArea area = enclosed_area(lines, geo.hole_points, model.grid);
    if (area.outlines.size() != 1)
        domain.fail("geo_file",
                    area.outlines.empty()
                        ? "the lines enclose nothing"
                        : "the lines enclose " + std::to_string(area.outlines.size()) +
                              " areas that share no edge, the second at " + text_of(area.outlines[1][0]),
                    "lines that enclose one area, or a coarser grid that joins their ends");
    model.outline = area.outlines[0];
    if (const auto fault = find_ring_fault(std::vector<Ring>{model.outline}))
        domain.fail("geo_file",
                    "two parts of the enclosed area meet only in the point " + text_of(fault->place),
                    "parts that share an edge");
    for (std::size_t k = 0; k < geo.hole_points.size(); ++k)
        if (area.faces[k])
            model.tunnels.push_back({numbered("hole", k), *area.faces[k], domain.place("geo_file")});
        else
            model.notes.push_back("hole point " + text_of(geo.hole_points[k]) + " lies outside all lines");
}

}  // namespace

void read_geo_domain(const ConfigTable& domain, const EnclosedAreaFunction& enclosed_area,
                     SlopeModel& model) {
    const SourceLocation place = domain.place("geo_file");
    model.files.push_back(domain.file_path("geo_file"));
    const GeoFile geo = read_geo_file(model.files.back());
    add_rock(domain, geo, enclosed_area, model);
    model.outline_of_traces = true;
    for (const GeoLine& line : geo.joints) {
        const std::string name = "joint " + std::to_string(line.number);
        model.traces.push_back({name, name, {line.a, line.b}});
    }
    for (const GeoLine& line : geo.material_lines)
        model.material_lines.push_back({"block " + std::to_string(line.number), line.a, line.b, place});
    for (const GeoLine& line : geo.fixed_lines) {
        BlockSelector selector;
        selector.place = place;
        if (line.a == line.b)
            selector.at = line.a;
        else
            selector.along = {line.a, line.b};
        model.selectors.push_back(selector);
    }
    for (std::size_t k = 0; k < geo.bolts.size(); ++k)
        model.bolts.push_back({numbered("bolt", k), "bolt", geo.bolts[k].a, geo.bolts[k].b, place});
    for (std::size_t k = 0; k < geo.measured_points.size(); ++k)
        model.measured_points.push_back({numbered("point", k), geo.measured_points[k], place});
    for (std::size_t k = 0; k < geo.loaded_points.size(); ++k)
        model.measured_points.push_back({numbered("load", k), geo.loaded_points[k], place});
    if (!geo.loaded_points.empty())
        model.notes.push_back("the loaded points of " + model.files.back().string() +
                              " are read as measured points 'load N'; loads are given in the run file");
    if (!geo.bolts.empty())
        model.notes.push_back("the stiffness of the bolts of " + model.files.back().string() +
                              " is ignored; the run file gives the bolt material 'bolt'");
}

}  // namespace rockslope::blockgen
