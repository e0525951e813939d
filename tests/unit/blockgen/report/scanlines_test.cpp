#include "blockgen/report/scanlines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::scanlines_test {
namespace {

using testing::HasSubstr;

ScanlineCount count_along(SlopeModel model, Point from, Point to) {
    model.scanlines = {{"line", from, to}};
    return cut(model).report.scanlines.at(0);
}

// Pieces of 2, 1, 0.05, 3.95 and 3 m of a line that begins and ends outside the rock.
TEST(Scanlines, CountJointsAndPiecesInTheRock) {
    SlopeModel model = rectangle(10, 10);
    for (const double x : {2.0, 3.0, 3.05}) add_trace(model, {{x, -1}, {x, 11}});
    add_trace(model, {{7, 1}, {7, 4}});  // ends in rock
    const ScanlineCount line = count_along(model, {-1, 2}, {12, 2});
    EXPECT_EQ(line.joints, 4u);
    EXPECT_NEAR(line.rock, 10, 1e-5);
    EXPECT_NEAR(line.rock_quality(), 99.5, 1e-3);
    EXPECT_NEAR(line.frequency(), 0.4, 1e-6);
    EXPECT_EQ(count_along(model, {-1, 6}, {12, 6}).joints, 3u) << "above the end of the last joint";
}

TEST(Scanlines, BeginAndEndInRockAndPassAHole) {
    SlopeModel model = rectangle(10, 10);
    model.holes = {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}};
    add_trace(model, {{2, -1}, {2, 11}});
    add_trace(model, {{8, -1}, {8, 11}});
    const ScanlineCount line = count_along(model, {9, 5}, {1, 5});
    EXPECT_EQ(line.joints, 2u);
    EXPECT_NEAR(line.rock, 6, 1e-5);
    const ScanlineCount beside = count_along(model, {4.5, 5}, {5.5, 5});
    EXPECT_EQ(beside.rock, 0);
    EXPECT_EQ(beside.rock_quality(), 0);
    EXPECT_EQ(beside.random_rock_quality(), 0);
}

// A slanting line: its length counts, not that across the joints.
TEST(Scanlines, AreAsLongAsTheyAre) {
    SlopeModel model = rectangle(10, 10);
    for (const double x : {2.0, 5.0}) add_trace(model, {{x, -1}, {x, 11}});
    const ScanlineCount line = count_along(model, {1, 1}, {9, 9});
    EXPECT_EQ(line.joints, 2u);
    EXPECT_NEAR(line.rock, 8 * std::sqrt(2.0), 1e-5);
}

// Joints at random places, 5 per metre: 100 exp(-0.5) 1.5 = 91.0 %. Over 400 m, 2000 pieces, the designation
// has a standard deviation of about 0.4 %.
TEST(Scanlines, OfRandomJointsHaveTheExpectedQuality) {
    const SlopeModel model = slope(R"(seed = 3
[domain]
outline = [[0, 0], [400, 0], [400, 2], [0, 2]]
block_material = "rock"
[[joint_set]]
name = "a"
angle = "90 deg"
spacing = { law = "exponential", mean = 0.2, min = 0 }
[[scanline]]
name = "core"
from = [0, 1]
to = [400, 1]
)");
    const CutReport report = cut(model).report;
    const ScanlineCount& line = report.scanlines.at(0);
    EXPECT_NEAR(line.frequency(), 5, 0.4);
    EXPECT_NEAR(line.random_rock_quality(), 91.0, 1.3);
    EXPECT_NEAR(line.rock_quality(), line.random_rock_quality(), 1.6) << "four standard deviations";
    EXPECT_NEAR(volumetric_joint_count(report.joints), line.frequency(), 1e-2);
    EXPECT_THAT(report_text(report), HasSubstr("\"name\": \"core\""));
    EXPECT_THAT(report_tables(report), HasSubstr("core"));
}

TEST(Scanlines, OfNoLengthAreRefused) {
    const auto read = [](const char* keys) {
        return slope(std::string("[domain]\noutline = [[0, 0], [1, 0], [1, 1]]\nblock_material = \"rock\"\n"
                                 "[[scanline]]\nname = \"a\"\nfrom = [0, 0]\n") +
                     keys);
    };
    EXPECT_THROW(read("to = [0, 0]\n"), InputError);
    EXPECT_THROW(read("to = [1, 0]\nsound_length = 0\n"), InputError);
    EXPECT_EQ(read("to = [1, 0]\nsound_length = \"5 cm\"\n").scanlines.at(0).sound_length, 0.05);
}

}  // namespace
}  // namespace rockslope::blockgen::scanlines_test
