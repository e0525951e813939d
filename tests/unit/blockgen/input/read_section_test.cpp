#include "blockgen/input/read_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blockgen/input/domain.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_section_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;

std::string text_with(const std::string& section) {
    return "[domain]\noutline = [[0, 0], [50, 0], [50, 30], [0, 30]]\nblock_material = \"rock\"\n"
           "[section]\n" +
           section +
           "\n[[joint_set]]\nname = \"planes\"\nspacing = 2\ndip = \"60 deg\"\ndip_direction = \"120 deg\"\n";
}

std::string error_with(const std::string& section) {
    return error_of([&] { slope(text_with(section)); });
}

TEST(ReadSection, TheAzimuthIsClockwiseFromGridNorth) {
    const Point from{1000, 2000};
    // Directions of 3-4-5 triangles and along the axes.
    for (const auto& [east, north, azimuth] : {std::tuple{0.0, 5.0, 0.0},
                                               {3.0, 4.0, std::atan2(3, 4)},
                                               {5.0, 0.0, 90 * degree},
                                               {4.0, -3.0, 90 * degree + std::atan2(3, 4)},
                                               {0.0, -5.0, 180 * degree},
                                               {-5.0, 0.0, 270 * degree},
                                               {-3.0, 4.0, 360 * degree - std::atan2(3, 4)}}) {
        const SectionLine line{from, {from.x + east, from.y + north}};
        EXPECT_NEAR(line.azimuth(), azimuth, 1e-15) << east << ' ' << north;
        EXPECT_EQ(line.length(), 5);
    }
}

TEST(ReadSection, PointsOfTheMapHaveAPlaceAlongTheLineAndADistanceFromIt) {
    const SectionLine line{{100, 200}, {130, 240}};
    EXPECT_EQ(line.at(0), (Point{100, 200}));
    EXPECT_EQ(line.at(50), (Point{130, 240}));
    EXPECT_EQ(line.at(10), (Point{106, 208}));
    const Point left{106 - 4, 208 + 3};  // 5 m to the left of the point at 10 m
    EXPECT_DOUBLE_EQ(line.along(left), 10);
    EXPECT_DOUBLE_EQ(line.across(left), 5);
}

/// A set given by planes is the same whether the azimuth is given or follows from the line.
TEST(ReadSection, PlanesInSpaceUseTheAzimuthOfTheLine) {
    const SlopeModel given = slope(text_with("azimuth = \"90 deg\""));
    const SlopeModel drawn = slope(text_with("from = [466000, 6691500]\nto = [466050, 6691500]"));
    ASSERT_TRUE(drawn.section);
    EXPECT_TRUE(drawn.section->on_map);
    EXPECT_FALSE(given.section->on_map);
    EXPECT_EQ(drawn.section->azimuth, given.section->azimuth);
    EXPECT_EQ(drawn.joint_sets[0].spacing.mean, given.joint_sets[0].spacing.mean);
    // tan 60 deg cos 30 deg = 3/2, downwards
    EXPECT_NEAR(std::tan(drawn.joint_sets[0].orientation.mean_angle()), -1.5, 1e-12);
    // Seen from the other side the same planes rise to the right.
    const SlopeModel reversed = slope(text_with("from = [466050, 6691500]\nto = [466000, 6691500]"));
    EXPECT_NEAR(std::tan(reversed.joint_sets[0].orientation.mean_angle()), 1.5, 1e-12);
}

TEST(ReadSection, AnAzimuthBesideTheLineMustAgree) {
    // The line's azimuth is 45 deg; readings in whole degrees may be half a degree off, on either side of
    // north.
    const std::string line = "from = [0, 0]\nto = [30, 30]\nazimuth = ";
    EXPECT_NEAR(slope(text_with(line + "\"45.4 deg\"")).section->azimuth, 45 * degree, 1e-15);
    EXPECT_EQ(slope(text_with("from = [0, 0]\nto = [0, 30]\nazimuth = \"359.6 deg\"")).section->azimuth, 0);
    EXPECT_THAT(
        error_with(line + "\"46 deg\""),
        AllOf(HasSubstr("slope.toml:7:11: "), HasSubstr("of 46 deg is not that of the section line, 45 deg"),
              HasSubstr("grid north")));
    EXPECT_THAT(error_with(line + "\"225 deg\""), HasSubstr("225 deg is not that of the section line"));
}

TEST(ReadSection, LinesThatAreNoneAreRefused) {
    EXPECT_THAT(error_with("from = [0, 0]"), HasSubstr("one end"));
    EXPECT_THAT(error_with("to = [0, 0]"), HasSubstr("one end"));
    EXPECT_THAT(error_with("from = [3, 4]\nto = [3, 4]"),
                AllOf(HasSubstr("slope.toml:6:6: "), HasSubstr("no length: it starts and ends at (3, 4)")));
    EXPECT_THAT(error_with(""), HasSubstr("azimuth"));
    EXPECT_THAT(error_with("from = [0, nan]\nto = [3, 4]"), HasSubstr("slope.toml:5"));
}

/// Blocks of a vertical section are not at home in the map's system.
TEST(ReadSection, BlocksOfAVerticalSectionStateNoSystem) {
    const std::string project = "[domain]\nproject = \"EPSG:32634\"";
    const auto urn_with = [&](const std::string& section) {
        std::string text = text_with(section);
        text.replace(0, std::string("[domain]").size(), project);
        return system_urn(slope(text));
    };
    EXPECT_EQ(urn_with("azimuth = \"90 deg\""), "urn:ogc:def:crs:EPSG::32634");
    EXPECT_EQ(urn_with("from = [466000, 6691500]\nto = [466050, 6691500]"), "");
}

}  // namespace
}  // namespace rockslope::blockgen::read_section_test
