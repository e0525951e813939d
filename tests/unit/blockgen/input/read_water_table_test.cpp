#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "blockgen/mesh/block_file.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_water_table_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
namespace fs = std::filesystem;

const std::string box =
    "[domain]\noutline = [[0, 0], [20, 0], [20, 10], [0, 10]]\nblock_material = \"rock\"\n";

std::string error_in(const std::string& keys) {
    return error_of([&] { slope(box + "[water_table]\n" + keys); });
}

TEST(WaterTable, IsCarriedByTheBlockFile) {
    const CutResult result =
        cut(slope(box + "[water_table]\nline = [[25, \"400 cm\"], [10, 5], [-3, 6.5]]\n"));
    EXPECT_THAT(result.mesh.water_table, ElementsAre(Point{-3, 6.5}, Point{10, 5}, Point{25, 4}));
    const std::string text = block_file_text(result.mesh);
    EXPECT_THAT(text,
                AllOf(StartsWith("ddablk 3\n"), HasSubstr(" bolts 0 excavations 0 water_table_points 3\n"),
                      HasSubstr("\nwater_table_point -3 6.5\nwater_table_point 10 5\nwater_table_point 25 "
                                "4\nend\n")));
    EXPECT_EQ(parse_block_file(text, "x"), result.mesh);
    EXPECT_EQ(block_file_text(parse_block_file(text, "x")), text);
    // Blocks are those without it.
    CutResult dry = cut(slope(box));
    EXPECT_THAT(block_file_text(dry.mesh), StartsWith("ddablk 1\n"));
    dry.mesh.water_table = result.mesh.water_table;
    EXPECT_EQ(dry.mesh, result.mesh);
}

TEST(WaterTable, MayComeFromAFile) {
    const fs::path file = fs::path(testing::TempDir()) / ("water_" + std::to_string(::getpid()) + ".csv");
    std::ofstream(file) << "x,y\n0,3\n20,1\n";
    const SlopeModel model = slope(box + "[water_table]\nline_file = \"" + file.string() + "\"\n");
    fs::remove(file);
    EXPECT_THAT(model.water_table, ElementsAre(Point{0, 3}, Point{20, 1}));
    EXPECT_THAT(model.files, ElementsAre(file));
    EXPECT_THAT(slope(box).water_table, IsEmpty());
}

TEST(WaterTable, BelowTheSectionIsNoted) {
    EXPECT_THAT(slope(box + "[water_table]\nline = [[-9, 8], [-1, -1], [20, -3]]\n").notes,
                ElementsAre(HasSubstr("the water table lies below the section")));
    EXPECT_THAT(slope(box + "[water_table]\nline = [[0, 2], [20, -3]]\n").notes, IsEmpty());
    EXPECT_THAT(slope(box + "[water_table]\nline = [[0, 30]]\n").notes, IsEmpty());  // under water
}

TEST(WaterTable, FaultsAreNamed) {
    EXPECT_THAT(error_in(""), HasSubstr("'line' and 'line_file' in [water_table] are missing"));
    EXPECT_THAT(error_in("line = []\n"), HasSubstr("a line without a point"));
    EXPECT_THAT(error_in("line = [[0, 3], [8, 3], [8, 2], [20, 2]]\n"), HasSubstr("has a step at x = 8"));
    EXPECT_THAT(error_in("line = [[0, 3], [8, 3], [7, 2], [20, 2]]\n"),
                AllOf(HasSubstr("slope.toml:5:"), HasSubstr("turns back before (7, 2)")));
    EXPECT_THAT(error_in("line = [[100, 3], [108, 3]]\n"), HasSubstr("lies beside the domain"));
    EXPECT_THAT(error_in("line = [[0, \"3 deg\"]]\n"), HasSubstr("slope.toml:5:"));
    EXPECT_THAT(error_in("head = [[0, 3]]\nline = [[0, 3]]\n"), HasSubstr("'head'"));
}

constexpr const char* wet_block = R"(ddablk 3
counts provenance 0 block_materials 1 joint_materials 0 joints 0 vertices 3 blocks 1 rings 1 corners 3 measured_points 0 bolts 0 excavations 0 water_table_points 2
block_material rock
vertex 0 0
vertex 1 0
vertex 0 1
block 0 1 free
ring 0 1 2
edges - - -
water_table_point 0 0.5
water_table_point 1 0.25
end
)";

std::string error_after(const std::string& from, const std::string& to) {
    std::string text = wet_block;
    text.replace(text.find(from), from.size(), to);
    return error_of([&] { parse_block_file(text, "slope.blocks"); });
}

TEST(WaterTable, OfABlockFileIsReadStrictly) {
    EXPECT_THAT(parse_block_file(wet_block, "x").water_table, ElementsAre(Point{0, 0.5}, Point{1, 0.25}));
    EXPECT_EQ(block_file_text(parse_block_file(wet_block, "x")), wet_block);
    EXPECT_THAT(error_after("point 1 0.25", "point 0 0.25"),
                AllOf(HasSubstr("slope.blocks:11:"), HasSubstr("x does not grow along the water table")));
    EXPECT_THAT(error_after("point 1 0.25", "point 1 nan"), HasSubstr("not a finite number"));
    EXPECT_THAT(error_after("point 1 0.25", "point 1 2e30"), HasSubstr("too large"));
    EXPECT_THAT(error_after("point 1 0.25", "point 1 0.25 3"), HasSubstr("one word too many"));
    EXPECT_THAT(error_after("table_points 2", "table_points 3"), HasSubstr("out of place"));
    EXPECT_THAT(error_after("table_points 2", "table_points 1"), HasSubstr("out of place"));
    EXPECT_THAT(error_after("table_points 2", "table_points 2000000000"), HasSubstr("too short"));
    EXPECT_THAT(error_after(" water_table_points 2", ""), HasSubstr("ends early"));
    EXPECT_THAT(error_after("ddablk 3", "ddablk 2"), HasSubstr("one word too many"));
}

}  // namespace
}  // namespace rockslope::blockgen::read_water_table_test
