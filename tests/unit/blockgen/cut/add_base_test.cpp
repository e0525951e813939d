#include "blockgen/cut/add_base.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "blockgen/mesh/measures.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::add_base_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::string slope_text(const std::string& base,
                       const std::string& outline = "[[0, 0], [120, 0], [120, 30], [60, 70], [0, 70]]") {
    return "seed = 3\n[domain]\noutline = " + outline + "\nblock_material = \"sandstone\"\n" + base +
           "[[joint_set]]\nname = \"bedding\"\nangle = \"-25 deg\"\nspacing = 6\n"
           "[[joint_set]]\nname = \"cross\"\nangle = \"65 deg\"\nspacing = 8\n";
}

std::size_t prescribed(const BlockMesh& mesh) {
    std::size_t count = 0;
    for (const BlockIndex b : mesh.blocks()) count += mesh.motion[b] == BlockMotion::prescribed;
    return count;
}

/// The area of blocks of a material, m2.
double area_of(const BlockMesh& mesh, const std::string& material) {
    double area = 0;
    for (const BlockIndex b : mesh.blocks())
        if (mesh.block_materials[mesh.block_material[b]] == material) area += block_area(mesh, b);
    return area;
}

TEST(AddBase, OneBlockStandsBelowAndBehindTheSlope) {
    const CutResult bare = cut(slope(slope_text("")));
    const CutResult result =
        cut(slope(slope_text("[base]\nbelow = 10\nbehind = 12\nahead = 5\nmaterial = \"bedrock\"\n")));
    ASSERT_EQ(result.report.blocks, bare.report.blocks + 1);
    EXPECT_EQ(prescribed(result.mesh), 1u);
    // Below 137 m x 10 m, behind 12 m x 70 m at the crest, ahead 5 m x 30 m at the toe.
    EXPECT_NEAR(area_of(result.mesh, "bedrock"), 1370 + 840 + 150, 1e-3);
    EXPECT_NEAR(area_of(result.mesh, "sandstone"), bare.report.domain_area, 1e-3);
    EXPECT_THAT(result.mesh.joint_materials, Contains("base"));
    EXPECT_THAT(result.report.warnings, testing::IsEmpty());
    // The joints do not enter the base, so the slope's densities and sizes are those without it.
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(result.report.joints[k].p21, bare.report.joints[k].p21, 1e-6);
        EXPECT_NEAR(result.report.joints[k].retained, bare.report.joints[k].retained, 1e-3);
    }
    EXPECT_NEAR(result.report.free_sizes.d50, bare.report.sizes.d50, 1e-6);
    EXPECT_NEAR(result.report.joints[2].retained, 70 + 120 + 30, 1e-6);
}

TEST(AddBase, ASlopeThatFallsToTheLeftHasItsBackOnTheRight) {
    const CutResult result = cut(slope(slope_text("[base]\nbelow = 1\nbehind = 12\nmaterial = \"bedrock\"\n",
                                                  "[[0, 0], [120, 0], [120, 70], [60, 70], [0, 30]]")));
    EXPECT_NEAR(area_of(result.mesh, "bedrock"), 132 + 840, 1e-3);
    // The toe's 30 m are free; the base's metre below them is held.
    EXPECT_THAT(result.report.warnings,
                testing::ElementsAre(HasSubstr("nothing holds 30 m of the 31 m of the section's left side")));
}

TEST(AddBase, TheSameMaterialIsPartedByTheJointToo) {
    const SlopeModel model = slope(slope_text(
        "[base]\nbelow = 2\nmaterial = \"sandstone\"\nmotion = \"fixed\"\njoint_material = \"contact\"\n"
        "name = \"ground\"\n"));
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.blocks, cut(slope(slope_text(""))).report.blocks + 1);
    EXPECT_EQ(prescribed(result.mesh), 0u);
    EXPECT_THAT(result.mesh.motion, Contains(BlockMotion::fixed));
    EXPECT_THAT(result.mesh.joint_materials, Contains("contact"));
    EXPECT_EQ(result.report.joints[2].name, "ground");
}

TEST(AddBase, InclinedAndCrookedLowerSidesAreFollowed) {
    const std::string outline = "[[0, 5], [30, -3], [60, 2.5], [90, 1], [90, 20], [40, 50], [0, 50]]";
    const CutResult bare = cut(slope(slope_text("", outline)));
    const CutResult result =
        cut(slope(slope_text("[base]\nbelow = 4\nbehind = 6\nmaterial = \"bedrock\"\n", outline)));
    EXPECT_EQ(result.report.blocks, bare.report.blocks + 1);
    EXPECT_NEAR(result.report.domain_area, bare.report.domain_area + area_of(result.mesh, "bedrock"), 1e-6);
    EXPECT_EQ(result.mesh.joint_materials.size(), 3u);
}

TEST(AddBase, GivenTracesEndAtTheBase) {
    SlopeModel model = slope(slope_text("[base]\nbelow = 10\nmaterial = \"bedrock\"\n"));
    model.joint_sets.clear();
    add_trace(model, {{20, -8}, {20, 40}, {30, 80}}, "fault");
    add_trace(model, {{10, -5}, {90, -5}}, "below");
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.blocks, 3u);
    EXPECT_NEAR(result.report.joints[0].retained, 40 + std::hypot(7.5, 30), 1e-6);
}

TEST(AddBase, FaultsOfTheTableAreNamed) {
    const auto error = [](const std::string& base) { return error_of([&] { slope(slope_text(base)); }); };
    EXPECT_THAT(error("[base]\nbelow = 0\nmaterial = \"r\"\n"), HasSubstr("slope.toml:6:9"));
    EXPECT_THAT(error("[base]\nbelow = 2\nbehind = -1\nmaterial = \"r\"\n"), HasSubstr("zero or more"));
    EXPECT_THAT(error("[base]\nbelow = 2\n"), HasSubstr("material"));
    EXPECT_THAT(error_of([] {
                    slope(
                        "[domain]\noutlines = [[[0, 0], [2, 0], [2, 2]], [[5, 0], [6, 0], [6, 1]]]\n"
                        "block_material = \"rock\"\n[base]\nbelow = 2\nmaterial = \"r\"\n");
                }),
                HasSubstr("slope.toml:5:9: a part of the domain shares no edge with the others, at (5, 0); "
                          "expected [base] for parts that share edges"));
    EXPECT_THAT(error_of([] {
                    slope(
                        "[domain]\noutlines = [[[0, 0], [2, 0], [2, 2], [0, 2]], [[2, 2], [4, 2], [4, 5]]]\n"
                        "block_material = \"rock\"\n[base]\nbelow = 2\nmaterial = \"r\"\n");
                }),
                HasSubstr("shares no edge with the others"));
}

TEST(AddBase, LiesBelowPartsThatShareEdges) {
    // The slope in three parts: inclined edges in common, of which one is longer than the other's, and
    // corners that no double hits exactly.
    const std::string parts =
        "[[0, 0], [40, 0], [50, 33.3], [45.1, 70], [0, 70]], [[40, 0], [80.7, 0], [70, 30], [50, 33.3]], "
        "[[50, 33.3], [70, 30], [80.7, 0], [120, 0], [120, 30], [60, 70], [45.1, 70]]";
    const std::string base = "[base]\nbelow = 10\nbehind = 12\nahead = 5\nmaterial = \"bedrock\"\n";
    const std::string joints = "[[joint_set]]\nname = \"bedding\"\nangle = \"-25 deg\"\nspacing = 6\n";
    const auto model = [&](const std::string& outline) {
        return slope("seed = 3\n[domain]\n" + outline + "\nblock_material = \"sandstone\"\n" + base + joints);
    };
    const CutResult whole = cut(model("outline = [[0, 0], [120, 0], [120, 30], [60, 70], [0, 70]]"));
    const CutResult result = cut(model("outlines = [" + parts + "]"));
    EXPECT_EQ(result.report.blocks, whole.report.blocks);
    EXPECT_EQ(prescribed(result.mesh), 1u);
    EXPECT_NEAR(area_of(result.mesh, "bedrock"), 1370 + 840 + 150, 1e-3);
    EXPECT_NEAR(area_of(result.mesh, "sandstone"), area_of(whole.mesh, "sandstone"), 1e-3);
    EXPECT_NEAR(result.report.joints.back().retained, 70 + 120 + 30, 1e-5);
    EXPECT_EQ(result.report.warnings, whole.report.warnings);
}

TEST(AddBase, LiesBelowPartsThatTouchAlongTheBaseOnly) {
    // A thin sole joins two benches; without it they would share no edge.
    const CutResult result = cut(
        slope("[domain]\noutlines = [[[0, 1], [4, 1], [3, 5], [0, 5]], [[6, 1], [10, 1], [10, 3], [6, 3]], "
              "[[0, 0], [10, 0], [10, 1], [0, 1]]]\nblock_material = \"rock\"\n"
              "[base]\nbelow = 2\nmaterial = \"r\"\n"));
    EXPECT_EQ(result.report.blocks, 2u);
    EXPECT_NEAR(area_of(result.mesh, "r"), 20, 1e-5);
    EXPECT_NEAR(area_of(result.mesh, "rock"), 14 + 8 + 10, 1e-5);
}

}  // namespace
}  // namespace rockslope::blockgen::add_base_test
