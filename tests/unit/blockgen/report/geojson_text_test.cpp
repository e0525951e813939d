#include "blockgen/report/geojson_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "blockgen/input/geojson.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::geojson_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A rock of 10 x 6 m with an island of 4 m2, a layer of another material and two joints.
CutResult section() {
    SlopeModel model = slope(R"([domain]
outline = [[0, 0], [10, 0], [10, 6], [0, 6]]
block_material = "rock \"a\""
[[region]]
name = "top"
block_material = "soil"
joint_material = "contact"
polygon = [[0, 5], [10, 5], [10, 7], [0, 7]]
[[fixed_block]]
at = [1, 1]
)");
    add_trace(model, {{6, -1}, {6, 8}}, "fault");
    add_trace(model, {{2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}}, "ring");
    return cut(model);
}

/// The features of one kind, without the others, as a file.
std::filesystem::path file_of(const std::string& text, const std::string& kind) {
    const auto path = std::filesystem::path(testing::TempDir()) /
                      ("geojson_text_" + std::to_string(::getpid()) + kind + ".geojson");
    std::ofstream file(path);
    std::size_t start = 0, written = 0;
    while (start < text.size()) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        std::string line = text.substr(start, end - start);
        start = end + 1;
        if (line.ends_with(',') && line.starts_with("{\"type\":\"Feature\"")) line.pop_back();
        if (line.starts_with("{\"type\":\"Feature\",")) {
            if (line.find("\"what\":\"" + kind) == std::string::npos) continue;
            file << (written++ > 0 ? "," : "");
        }
        file << line << "\n";
    }
    return path;
}

TEST(GeoJsonText, BlocksAndJointsAreReadBack) {
    const CutResult result = section();
    const std::string text = geojson_text(result.mesh, "urn:ogc:def:crs:EPSG::3067");
    const MapPolygons blocks = read_geojson_polygons(file_of(text, "block"));
    EXPECT_EQ(blocks.notes.system, "urn:ogc:def:crs:EPSG::3067");
    ASSERT_EQ(blocks.polygons.size(), result.report.blocks);
    double area = 0, holes = 0;
    for (const std::vector<Ring>& polygon : blocks.polygons)
        for (std::size_t r = 0; r < polygon.size(); ++r) {
            const Ring ring(polygon[r].begin(), polygon[r].end() - 1);
            (r == 0 ? area : holes) += twice_signed_area(ring) / 2;
        }
    EXPECT_EQ(area + holes, 60);
    EXPECT_EQ(holes, -4);
    const MapLines joints = read_geojson_lines(file_of(text, "joint"));
    double faults = 0, contacts = 0, rings = 0;
    for (const MapLine& line : joints.lines) {
        ASSERT_EQ(line.points.size(), 2u);
        const double length =
            std::hypot(line.points[1].x - line.points[0].x, line.points[1].y - line.points[0].y);
        (line.joint_material == "fault"     ? faults
         : line.joint_material == "contact" ? contacts
                                            : rings) += length;
    }
    EXPECT_EQ(faults, 6);
    EXPECT_EQ(contacts, 10);
    EXPECT_EQ(rings, 8);
    EXPECT_THAT(text, HasSubstr(R"("block_material":"rock \"a\"","area_m2":)"));
    EXPECT_THAT(text, HasSubstr(R"("motion":"fixed")"));
    EXPECT_THAT(text, HasSubstr(R"("name":"outline","joint_material":"contact")"));
}

TEST(GeoJsonText, TheWaterTableRunsFromSideToSide) {
    CutResult result = section();
    EXPECT_THAT(geojson_text(result.mesh, ""), Not(HasSubstr("water_table")));
    result.mesh.water_table = {{-5, 1}, {5, 3}, {8, 3.5}};
    const MapLines water = read_geojson_lines(file_of(geojson_text(result.mesh, ""), "water_table"));
    ASSERT_EQ(water.lines.size(), 1u);
    EXPECT_EQ(water.lines[0].points, (std::vector<Point>{{0, 2}, {5, 3}, {8, 3.5}, {10, 3.5}}));
}

TEST(GeoJsonText, WithoutASystemNoneIsStated) {
    EXPECT_THAT(geojson_text(section().mesh, ""), Not(HasSubstr("crs")));
}

}  // namespace
}  // namespace rockslope::blockgen::geojson_text_test
