#include "blockgen/input/geo_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "blockgen/cut/apply_block_selectors.hpp"
#include "blockgen/faces/enclosed_area.hpp"
#include "common/base/input_error.hpp"
#include "support/error_of.hpp"
#include "support/replaced.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::geo_file_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A wall of two courses on a plinth, with a window. Lines overshoot by up to 0.01, as digitised lines do.
const char* wall = R"(0.01
8 0
1
1
2
1
1
1
0 0 6 0 1
6 0 6 4 1
6 4 0 4 1
0 4 0 0 1
-0.01 1 6.01 1 2
3 0.995 3 4.01 3
2 2 4 2 2
4 2 4 3 3
0.5 0.5 5.5 0.5 7
0.5 3.5 5.5 3.5 1e6 2e5 0
0.2 0.2 0.2 0.2
1 0.4 5 0.4
5 3.9
1 3.5
3.5 2.5
)";

std::string written(const std::string& text) {
    // The tests of this file run concurrently in separate processes.
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("geo_file_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "shi.geo") << text;
    return folder / "shi.geo";
}

TEST(GeoFile, ReadsTheCountedRecords) {
    const GeoFile geo = read_geo_file(written(wall));
    EXPECT_EQ(geo.edge_node_distance, 0.01);
    ASSERT_EQ(geo.joints.size(), 8u);
    EXPECT_EQ(geo.joints[5].a, (Point{3, 0.995}));
    EXPECT_EQ(geo.joints[5].number, 3);
    EXPECT_EQ(geo.material_lines.at(0).number, 7);
    EXPECT_EQ(geo.bolts.at(0).b, (Point{5.5, 3.5}));
    EXPECT_EQ(geo.fixed_lines.size(), 2u);
    EXPECT_EQ(geo.loaded_points.at(0), (Point{5, 3.9}));
    EXPECT_EQ(geo.measured_points.at(0), (Point{1, 3.5}));
    EXPECT_EQ(geo.hole_points.at(0), (Point{3.5, 2.5}));
}

std::string error_of(const std::string& text, const std::string& from, const std::string& to) {
    return rockslope::error_of([&] { read_geo_file(written(replaced(text, from, to))); });
}

TEST(GeoFile, ErrorsHaveTheirLocation) {
    EXPECT_THAT(error_of(wall, "6 4 0 4 1", "6 4 zero 4 1"),
                HasSubstr("shi.geo:11:5: 'zero' is not a number"));
    EXPECT_THAT(error_of(wall, "8 0", "8.5 0"), HasSubstr("2:1: 8.5 is not a count"));
    EXPECT_THAT(error_of(wall, "8 0", "-1 0"), HasSubstr("not a count"));
    EXPECT_THAT(error_of(wall, "3.5 2.5\n", ""), HasSubstr("the file ends"));
    EXPECT_THAT(error_of(wall, "3.5 2.5\n", "3.5 2.5 1\n"), HasSubstr("words after the last point"));
    EXPECT_THAT(error_of(wall, "4 3 3", "4 3 3.3"), HasSubstr("not a material number"));
    EXPECT_THAT(error_of(wall, "0.01", "nan"), HasSubstr("'nan' is not a number"));
    EXPECT_THAT(error_of(wall, "0.01", "<?xml"), HasSubstr("XML"));
    EXPECT_THROW(read_geo_file("no-such.geo"), InputError);
}

SlopeModel model_of(const std::string& text, const std::string& more = "") {
    return slope("[domain]\ngeo_file = \"" + written(text) + "\"\nblock_material = \"rock\"\n" + more);
}

TEST(GeoFile, BecomesBlocks) {
    // The window lacks a side, so its hole point would remove all rock right of it. The test adds the side.
    const std::string closed = std::string(wall).replace(std::string(wall).find("8 0"), 3, "9 0");
    std::string with_lid = closed;
    with_lid.replace(with_lid.find("4 2 4 3 3\n"), 10, "4 2 4 3 3\n4 3 3 3 2\n");
    const CutResult window = cut(model_of(with_lid));
    EXPECT_EQ(window.mesh.block_count(), 3u);
    EXPECT_EQ(window.report.domain_area, 23);
    EXPECT_THAT(window.mesh.joint_materials, testing::UnorderedElementsAre("joint 2", "joint 3"));
    const auto at = [&](const Point& p) { return static_cast<std::size_t>(block_at(window.mesh, p)); };
    const auto material = [&](const Point& p) {
        return window.mesh.block_materials[window.mesh.block_material[at(p)]];
    };
    EXPECT_EQ(material({1, 0.5}), "block 7");
    EXPECT_EQ(material({1, 2.5}), "rock");
    EXPECT_EQ(window.mesh.motion[at({1, 0.5})], BlockMotion::fixed);
    EXPECT_EQ(window.mesh.motion[at({1, 2.5})], BlockMotion::free);
    ASSERT_EQ(window.mesh.measured_points.size(), 2u);
    EXPECT_EQ(window.mesh.measured_points[1].name, "load 1");
    EXPECT_EQ(window.mesh.bolts.size(), 1u);
    EXPECT_THAT(window.report.warnings,
                ElementsAre(HasSubstr("loads are given in the run file"), HasSubstr("bolt"),
                            HasSubstr("nothing holds 3 m"), HasSubstr("nothing holds 3 m")));
}

TEST(GeoFile, OtherTablesAddToTheGeoFile) {
    const SlopeModel model =
        model_of("0.01\n4 4\n0\n0\n0\n0\n0\n0\n0 0 1 0 1\n1 0 1 1 1\n1 1 0 1 1\n0 1 0 0 1\n",
                 "[[joint_set]]\nname = \"a\"\nangle = \"0 deg\"\nspacing = 0.25\n");
    const CutResult result = cut(model);
    EXPECT_GE(result.mesh.block_count(), 4u);
    EXPECT_TRUE(result.report.warnings.empty());
}

TEST(GeoFile, LinesThatEncloseNoAreaOrTwoAreRefused) {
    const std::string head = "0.01\n3 0\n0\n0\n0\n0\n0\n0\n";
    EXPECT_THROW(model_of(head + "0 0 1 0 1\n1 0 1 1 1\n1 1 0 1 1\n"), InputError);
    EXPECT_THROW(model_of("0.01\n0 0\n0\n0\n0\n0\n0\n0\n"), InputError);
    const std::string two = "0.01\n6 0\n0\n0\n0\n0\n0\n0\n0 0 1 0 1\n1 0 0 1 1\n0 1 0 0 1\n";
    EXPECT_THROW(model_of(two + "5 0 6 0 1\n6 0 5 1 1\n5 1 5 0 1\n"), InputError);
    EXPECT_THROW(model_of(two + "0 0 -1 0 1\n-1 0 0 -1 1\n0 -1 0 0 1\n"), InputError);  // by a point
    EXPECT_THROW(model_of(wall, "outline = [[0, 0], [1, 0], [0, 1]]\n"), InputError);
}

TEST(EnclosedArea, FindsTheInnermostFace) {
    std::vector<std::pair<Point, Point>> lines;
    for (const double r : {4.0, 2.0, 1.0})
        for (const auto& [a, b] :
             {std::pair(Point{-r, -r}, Point{r, -r}), std::pair(Point{r, -r}, Point{r, r}),
              std::pair(Point{r, r}, Point{-r, r}), std::pair(Point{-r, r}, Point{-r, -r})})
            lines.emplace_back(a, b);
    const std::vector<Point> points = {{0, 0}, {1.5, 0}, {3, 0}, {5, 0}};
    const EnclosedArea area = enclosed_area(lines, points, 0x1p-20);
    ASSERT_EQ(area.outlines.size(), 1u);
    EXPECT_EQ(twice_signed_area(area.outlines[0]), 128);
    EXPECT_EQ(twice_signed_area(*area.faces[0]), 8);
    EXPECT_EQ(twice_signed_area(*area.faces[1]), 32);
    EXPECT_EQ(twice_signed_area(*area.faces[2]), 128);
    EXPECT_FALSE(area.faces[3].has_value());
}

TEST(FixedBlock, AlongALine) {
    const std::string text =
        "[domain]\noutline = [[0, 0], [3, 0], [3, 1], [0, 1]]\nblock_material = \"rock\"\n"
        "[[joint_set]]\nname = \"a\"\nangle = \"90 deg\"\nspacing = 1\norigin = [1, 0]\n[[fixed_block]]\n";
    const BlockMesh mesh = cut(slope(text + "along = [[0.5, 0.5], [1.5, 0.2]]\n")).mesh;
    EXPECT_EQ(std::count(mesh.motion.begin(), mesh.motion.end(), BlockMotion::fixed), 2);
    for (const char* bad : {"along = [[0, 0]]", "along = [[0, 0], [0, 0]]", "along = [[9, 9], [9, 10]]",
                            "along = [[0, 0], [1, 1]]\nat = [0, 0]"})
        EXPECT_THROW(cut(slope(text + bad + "\n")), InputError) << bad;
}

}  // namespace
}  // namespace rockslope::blockgen::geo_file_test
