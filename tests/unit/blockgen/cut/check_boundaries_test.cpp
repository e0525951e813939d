#include "blockgen/cut/check_boundaries.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::check_boundaries_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A square of 10 m in four layers.
std::string layers(const std::string& more) {
    return "[domain]\noutline = [[0, 0], [10, 0], [10, 10], [0, 10]]\nblock_material = \"rock\"\n"
           "[[joint_set]]\nname = \"bedding\"\nangle = \"0 deg\"\nspacing = 2.5\norigin = [0, 0]\n" +
           more;
}

std::vector<std::string> warnings_of(const std::string& text) {
    return cut(slope(text)).report.warnings;
}

TEST(CheckBoundaries, SidesThatNothingHoldsAreNamedWithTheirLength) {
    EXPECT_THAT(warnings_of(layers("")), IsEmpty());  // nothing is held at all: a section to look at
    EXPECT_THAT(warnings_of(layers("[[fixed_block]]\nside = \"bottom\"\n")),
                ElementsAre(HasSubstr("nothing holds 7.5 m of the 10 m of the section's left side"),
                            HasSubstr("nothing holds 7.5 m of the 10 m of the section's right side")));
    EXPECT_THAT(warnings_of(layers("[[fixed_block]]\nside = \"top\"\n")),
                testing::Contains(HasSubstr("nothing holds 10 m of the 10 m of the section's lower side")));
    EXPECT_THAT(warnings_of(layers("[[fixed_block]]\nside = \"left\"\n")), IsEmpty());
}

TEST(CheckBoundaries, ATinyPrescribedBlockIsNamed) {
    const std::string large = layers(
        "[[traces]]\njoint_material = \"chip\"\npoints = [[9, 0], [10, 1]]\n"
        "[[prescribed_block]]\nname = \"base\"\nat = [9.9, 0.1]\n");
    EXPECT_THAT(warnings_of(large), testing::Not(testing::Contains(HasSubstr("is tiny"))));  // 0.5 m2
    const std::string small = layers(
        "[[traces]]\njoint_material = \"chip\"\npoints = [[9.8, 0], [10, 0.2]]\n"
        "[small_blocks]\npolicy = \"keep\"\n"
        "[[prescribed_block]]\nname = \"base\"\nat = [9.97, 0.05]\n");
    EXPECT_THAT(warnings_of(small), testing::Contains(AllOf(HasSubstr("prescribed block 'base'"),
                                                            HasSubstr("is tiny: 0.02 m2"))));
}

TEST(CheckBoundaries, ARegionOutsideTheSectionIsNamed) {
    const auto region = [](const char* name, const char* polygon) {
        return "[[region]]\nname = \"" + std::string(name) + "\"\npolygon = " + polygon + "\n";
    };
    const std::string inside = region("inside", "[[3, 1], [7, 1], [7, 9], [3, 9]]"),
                      across = region("across", "[[8, 1], [12, 1], [12, 9], [8, 9]]"),
                      around = region("around", "[[-1, -1], [20, -1], [20, 20], [-1, 20]]"),
                      aside = region("aside", "[[30, 1], [34, 1], [34, 9], [30, 9]]");
    for (const std::string& some : {inside, across, around, inside + across})
        EXPECT_THAT(warnings_of(layers(some)), IsEmpty()) << some;
    EXPECT_THAT(warnings_of(layers(inside + aside)),
                ElementsAre(HasSubstr("region 'aside' lies outside the section")));
}

TEST(CheckBoundaries, ARegionWhoseJointMaterialHasNoEffectIsNamed) {
    const std::string region = "[[region]]\nname = \"zone\"\npolygon = [[3, 1], [7, 1], [7, 9], [3, 9]]\n";
    EXPECT_THAT(warnings_of(layers(region)), IsEmpty());
    EXPECT_THAT(warnings_of(layers(region + "joint_material = \"contact\"\n")),
                ElementsAre(AllOf(HasSubstr("region 'zone'"), HasSubstr("'contact' has no effect"))));
    EXPECT_THAT(warnings_of(layers(region + "joint_material = \"contact\"\nblock_material = \"soil\"\n")),
                IsEmpty());
    const std::string cells =
        "[[joint_set]]\nname = \"cells\"\nkind = \"voronoi\"\nregion = \"zone\"\ncount = 20\n";
    EXPECT_THAT(warnings_of(layers(region + cells)),
                ElementsAre(AllOf(HasSubstr("region 'zone'"), HasSubstr("Voronoi cells are one block"))));
}

}  // namespace
}  // namespace rockslope::blockgen::check_boundaries_test
