#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "blockgen/picture/block_picture.hpp"
#include "blockgen/picture/rose_picture.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::report_tables_test {
namespace {

using testing::HasSubstr;

CutResult sample() {
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{-1, 2}, {9, 2}}, "bedding");
    add_trace(model, {{2, -1}, {2, 2}}, "cross");
    add_trace(model, {{30, -1}, {40, 2}}, "stray");
    model.kinematics = KinematicScreen{std::numbers::pi / 6, {"bottom", "left", "right", "top"}};
    return cut(model);
}

TEST(ReportTables, AgreeWithTheJsonReport) {
    const CutResult result = sample();
    const std::string tables = report_tables(result.report), json = report_text(result.report);
    EXPECT_THAT(tables, HasSubstr("number                    3\n"));
    EXPECT_THAT(tables, HasSubstr("32 m2, filled exactly by the blocks"));
    EXPECT_THAT(tables, HasSubstr("bedding                  1      10.00       8.00       0.00"));
    EXPECT_THAT(tables, HasSubstr("1 abutments (Y)"));
    EXPECT_THAT(tables, HasSubstr("enclosed                 3"));
    EXPECT_THAT(tables, HasSubstr("1 trace of 'stray' lies outside the rock"));
    EXPECT_THAT(tables, HasSubstr("Directions"));
    EXPECT_THAT(json, HasSubstr("\"mean_corners\": 4.333"));
    EXPECT_THAT(json, HasSubstr("\"aspect\""));
    EXPECT_THAT(json, HasSubstr("\"enclosed\": 3"));
}

TEST(LengthByDirection, AddsUpToTheLengthInTheRock) {
    const std::vector<JointBalance> joints = sample().report.joints;
    for (const JointBalance& b : joints) {
        double sum = 0;
        for (const double length : b.length_by_direction) sum += length;
        EXPECT_NEAR(sum, b.retained + b.pruned, 1e-9) << b.name;
    }
    // The horizontal bedding is in the class from 0 to 10 degrees, a vertical joint in that from -90.
    EXPECT_NEAR(joints[0].length_by_direction[9], 8, 1e-9);
    EXPECT_NEAR(joints[1].length_by_direction[0], 2, 1e-9);
}

TEST(Pictures, DrawARoseOfTheSetsThatThereAre) {
    const std::vector<JointBalance> joints = sample().report.joints;
    std::vector<RoseSet> sets;
    EXPECT_LT(draw_rose(sets).bytes(PictureFormat::svg).size(), 1000u);
    for (const JointBalance& b : joints) sets.push_back({b.name, b.length_by_direction});
    const std::string rose = draw_rose(sets).bytes(PictureFormat::svg);
    EXPECT_EQ(rose, draw_rose(sets).bytes(PictureFormat::svg));
    for (const char* text : {"bedding", "cross", "-60\u00b0", "80 %"}) EXPECT_THAT(rose, HasSubstr(text));
}

TEST(Pictures, DrawSizesAndALayer) {
    const BlockMesh mesh = sample().mesh;
    const std::string sizes = draw_sizes(mesh).bytes(PictureFormat::svg);
    EXPECT_EQ(sizes, draw_sizes(mesh).bytes(PictureFormat::svg));
    EXPECT_GT(sizes.size(), 5000u);
    EXPECT_LT(draw_sizes(BlockMesh{}).bytes(PictureFormat::svg).size(), sizes.size());
    const std::string plain = draw_blocks(mesh).bytes(PictureFormat::svg);
    BlockLayer layer{"title", {{"entry", {1, 0, 0}}}, {-1, -1, -1}};
    const std::string with_legend = draw_blocks(mesh, layer).bytes(PictureFormat::svg);
    EXPECT_NE(plain, with_legend);
    layer.entry_of_block[1] = 0;
    EXPECT_NE(with_legend, draw_blocks(mesh, layer).bytes(PictureFormat::svg));
}

}  // namespace
}  // namespace rockslope::blockgen::report_tables_test
