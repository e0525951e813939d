#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "blockgen/sampling/rock_domain.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/material_areas.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_weathered_test {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

/// Blocks of the cut have their corners on the grid of 1e-6 m, and the base of a zone is some 60 m long.
const double rounding = 1e-4;

std::string domain(const std::string& outline, const std::string& more) {
    return "[domain]\noutline = " + outline + "\nblock_material = \"rock\"\n" + more;
}

/// A bench of 60 m by 20 m, and beyond its edge a slope of 3 : 1 down to the toe at 90 m.
std::string slope_with(const std::string& more) {
    return domain("[[0, 0], [90, 0], [90, 10], [60, 20], [0, 20]]", more);
}

std::string zone(const std::string& keys) {
    return "[[weathered]]\nblock_material = \"soil\"\njoint_material = \"contact\"\n" + keys;
}

std::map<std::string, double> areas_of(const std::string& text) {
    return material_areas(cut(slope(text)).mesh);
}

std::string error_in(const std::string& text) {
    return error_of([&] { cut(slope(text)); });
}

TEST(WeatheredZones, HaveTheirDepthUprightBelowTheSurface) {
    const CutResult result = cut(slope(slope_with(zone("depth = 3\n"))));
    // Depth times width, however steep the surface.
    EXPECT_THAT(material_areas(result.mesh), ElementsAre(Pair("rock", DoubleNear(1650 - 270, rounding)),
                                                         Pair("soil", DoubleNear(270, rounding))));
    EXPECT_THAT(result.mesh.joint_materials, ElementsAre("contact"));
    EXPECT_THAT(result.report.warnings, IsEmpty());
    EXPECT_THAT(areas_of(slope_with(zone("depth = \"300 cm\"\n"))), material_areas(result.mesh));
    EXPECT_THAT(
        areas_of(slope_with("[weathered]\nblock_material = \"soil\"\njoint_material = \"c\"\ndepth = 3\n")),
        material_areas(result.mesh));
    // Deeper than the toe is high: the zone ends at the bottom of the section.
    EXPECT_THAT(areas_of(slope_with(zone("depth = 12\n"))),
                ElementsAre(Pair("rock", DoubleNear(1650 - 90 * 12 + 6 * 2 / 2.0, rounding)),
                            Pair("soil", DoubleNear(90 * 12 - 6 * 2 / 2.0, rounding))));
    EXPECT_THAT(areas_of(slope_with(zone("depth = 50\n"))), ElementsAre(Pair("soil", 1650)));
}

TEST(WeatheredZones, BehindAWallAndUnderAnOverhangCountFromTheSurfaceAbove) {
    // A wall of 10 m at x = 10: its zone is no wider for it.
    EXPECT_THAT(
        areas_of(domain("[[0, 0], [20, 0], [20, 5], [10, 5], [10, 15], [0, 15]]", zone("depth = 2\n"))),
        ElementsAre(Pair("rock", 200 - 40), Pair("soil", 40)));
    // A roof of 4 m by 1 m over a hollow of 9 m: the zone fills the roof, and the floor below it lies deeper.
    EXPECT_THAT(areas_of(domain("[[0, 0], [20, 0], [20, 5], [8, 5], [8, 14], [12, 14], [12, 15], [0, 15]]",
                                zone("depth = 2\n"))),
                ElementsAre(Pair("rock", 8 * 13 + 4 * 5 + 8 * 3), Pair("soil", 8 * 2 + 4 + 8 * 2)));
}

TEST(WeatheredZones, LieInBandsOneBelowTheOther) {
    const std::string two = zone("name = \"deep\"\ndepth = 5\n") +
                            "[[weathered]]\nname = \"top\"\nblock_material = \"loam\"\n"
                            "joint_material = \"contact\"\ndepth = 1\n";
    EXPECT_THAT(areas_of(slope_with(two)), ElementsAre(Pair("loam", DoubleNear(90, rounding)),
                                                       Pair("rock", DoubleNear(1650 - 450, rounding)),
                                                       Pair("soil", DoubleNear(360, rounding))));
    const SlopeModel model = slope(slope_with(two));
    EXPECT_DOUBLE_EQ(RockDomain(model, "deep").area(), 360);
    EXPECT_DOUBLE_EQ(RockDomain(model, "top").area(), 90);
}

TEST(WeatheredZones, GiveASetItsDensityThere) {
    const std::string set =
        "kind = \"baecher\"\nangle = \"30 deg\"\ntrace_length = 0.5\njoint_material = \"crack\"\n";
    const SlopeModel model =
        slope("seed = 2\n" +
              slope_with("[weathered]\ndepth = 3\n"
                         "[[joint_set]]\nname = \"deep\"\np21 = 0.5\n" +
                         set + "[[joint_set]]\nname = \"near\"\np21 = 4\nregion = \"weathered\"\n" + set));
    const RockDomain zone(model, "weathered");
    EXPECT_NEAR(zone.area(), 270, rounding);
    double length = 0;
    for (const Trace& t : all_traces(model)) {
        const Point &a = t.points[0], &b = t.points[1], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        if (t.name != "near") continue;
        const double surface = middle.x < 60 ? 20 : 20 - (middle.x - 60) / 3;
        EXPECT_GT(middle.y, surface - 3 - 1e-9);
        length += zone.length_in(a, b);
    }
    EXPECT_NEAR(length / zone.area(), 4, 0.5 / zone.area());  // sampling ends within a trace of its target
    EXPECT_THAT(material_areas(cut(model).mesh), ElementsAre(Pair("rock", DoubleNear(1650, rounding))));
}

TEST(WeatheredZones, LieOverLayersAndUnderRegions) {
    const std::string layer =
        "[[layer]]\nname = \"sand\"\nblock_material = \"sand\"\njoint_material = \"c\"\n"
        "top = [[0, 18]]\n";
    EXPECT_THAT(areas_of(domain("[[0, 0], [30, 0], [30, 20], [0, 20]]", layer + zone("depth = 6\n"))),
                ElementsAre(Pair("sand", 30 * 14), Pair("soil", 30 * 6)));
    // Without a block material the zone leaves that of the layers, and parts nothing.
    const CutResult plain =
        cut(slope(domain("[[0, 0], [30, 0], [30, 20], [0, 20]]", layer + "[weathered]\ndepth = 6\n")));
    EXPECT_THAT(material_areas(plain.mesh), ElementsAre(Pair("rock", 30 * 2), Pair("sand", 30 * 18)));
    EXPECT_EQ(plain.mesh.block_count(), 2u);
    EXPECT_THAT(plain.report.warnings, IsEmpty());
    EXPECT_THAT(areas_of(domain("[[0, 0], [30, 0], [30, 20], [0, 20]]",
                                "[[region]]\nname = \"dyke\"\nblock_material = \"basalt\"\njoint_material = "
                                "\"c\"\npolygon = [[9, 0], [11, 0], [11, 20], [9, 20]]\n" +
                                    zone("depth = 6\n"))),
                ElementsAre(Pair("basalt", 40), Pair("rock", 28 * 14), Pair("soil", 28 * 6)));
}

TEST(WeatheredZones, OfASlopeWithABaseEndAtIt) {
    const CutResult result = cut(
        slope(slope_with(zone("depth = 3\n") + "[base]\nbelow = 5\nbehind = 4\nmaterial = \"bedrock\"\n")));
    EXPECT_THAT(material_areas(result.mesh),
                ElementsAre(Pair("bedrock", 94 * 5 + 4 * 20), Pair("rock", DoubleNear(1650 - 270, rounding)),
                            Pair("soil", DoubleNear(270, rounding))));
    EXPECT_EQ(result.mesh.block_count(), 3u);
}

TEST(WeatheredZones, FaultsAreNamed) {
    EXPECT_THAT(error_in(slope_with(zone(""))), HasSubstr("there is no key 'depth'"));
    EXPECT_THAT(error_in(slope_with(zone("depth = 0\n"))), HasSubstr("a depth below the surface"));
    EXPECT_THAT(error_in(slope_with(zone("depth = -3\n"))), HasSubstr("slope.toml:7:9"));
    EXPECT_THAT(error_in(slope_with(zone("depth = \"3 deg\"\n"))), HasSubstr("depth"));
    EXPECT_THAT(error_in(slope_with(zone("depth = nan\n"))), HasSubstr("finite"));
    EXPECT_THAT(error_in(slope_with(zone("depth = 3\n") + zone("depth = 4\n"))),
                HasSubstr("a second weathered zone 'weathered'"));
    EXPECT_THAT(error_in(slope_with(zone("depth = 3\n") + zone("name = \"b\"\ndepth = 3\n"))),
                HasSubstr("'weathered' and 'b' reach to the same depth"));
    EXPECT_THAT(error_in(slope_with(zone("depth = 30\n") + zone("name = \"b\"\ndepth = 40\n"))),
                AllOf(HasSubstr("weathered zone 'b' lies below the domain"), HasSubstr("'weathered'")));
    EXPECT_THAT(error_in(slope_with("[weathered]\ndepth = 3\njoint_material = \"c\"\n")),
                HasSubstr("a contact of a zone without block_material"));
    EXPECT_THAT(error_in(slope_with("[weathered]\ndepth = 3\nblock_material = \"soil\"\n")),
                AllOf(HasSubstr("weathered zone 'weathered' separates two block materials"),
                      HasSubstr("joint_material in the table of the weathered zone")));
}

}  // namespace
}  // namespace rockslope::blockgen::read_weathered_test
