#include "blockgen/cut/merge_blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/base/input_error.hpp"
#include "unit/blockgen/small_blocks.hpp"

namespace rockslope::blockgen::merge_blocks_test {
namespace {

TEST(SmallBlocks, AreKeptByDefault) {
    const CutResult result = cut(sliver(SmallBlockPolicy::keep));
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{0.5, 6, 10, 15.5}));
    EXPECT_EQ(result.report.merges.merged_blocks, 0u);
}

TEST(SmallBlocks, MergeAcrossTheLongestBoundary) {
    const CutResult result = cut(sliver(SmallBlockPolicy::merge));
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{6, 10, 16}));
    EXPECT_EQ(result.report.domain_area, 32);
    EXPECT_EQ(result.report.merges.small_blocks, 1u);
    EXPECT_EQ(result.report.merges.merged_blocks, 1u);
    EXPECT_EQ(result.report.merges.merged_area, 0.5);
    EXPECT_EQ(result.report.joints[1].name, "upper");
    EXPECT_NEAR(result.report.joints[1].pruned, 8, 1e-6);
}

TEST(SmallBlocks, DropThePieceOfTheShortestJoint) {
    // The upper and the lower joint have the same length. The lower one comes first and is dropped, and both
    // blocks beyond it are merged.
    const CutResult result = cut(sliver(SmallBlockPolicy::drop));
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{15.5, 16.5}));
    EXPECT_NEAR(result.report.joints[0].pruned, 8, 1e-6);
    EXPECT_NEAR(result.report.joints[2].pruned, 2, 1e-6);
}

TEST(SmallBlocks, SlenderBlocksAreMerged) {
    SlopeModel model = sliver(SmallBlockPolicy::merge);
    model.small_blocks = {SmallBlockPolicy::merge, 0, 0.05};  // the sliver has 4 pi 0.5 / 16.1^2 = 0.024
    EXPECT_EQ(cut(model).mesh.block_count(), 3u);
    model.small_blocks.below_roundness = 0.02;
    EXPECT_EQ(cut(model).mesh.block_count(), 4u);
}

TEST(SmallBlocks, AreNotMergedWithAnotherMaterial) {
    SlopeModel model = rectangle(4, 4);
    model.regions.push_back({"lens", "coal", "contact", {{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}}, {}});
    model.small_blocks = {SmallBlockPolicy::merge, 1, 0};
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 2u);
    EXPECT_EQ(result.report.merges.kept_small, 1u);
}

TEST(SmallBlocks, NoneRemainsAndTheAreaIsUnchanged) {
    std::mt19937 random(3);
    SlopeModel model = rectangle(16, 16);
    const auto coordinate = [&] { return 18 * static_cast<double>(random()) * 0x1p-32 - 1; };
    for (int k = 0; k < 80; ++k)
        add_trace(model, {{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    const CutResult before = cut(model);
    for (const SmallBlockPolicy policy : {SmallBlockPolicy::merge, SmallBlockPolicy::drop}) {
        model.small_blocks = {policy, 0.25, 0.1};
        const CutResult after = cut(model);
        EXPECT_LT(after.mesh.block_count(), before.mesh.block_count());
        EXPECT_GE(after.report.sizes.smallest_area, 0.25);
        EXPECT_EQ(after.report.slivers, 0u);
        EXPECT_EQ(after.report.domain_area, before.report.domain_area);
        EXPECT_EQ(after.mesh.block_count() + after.report.merges.merged_blocks, before.mesh.block_count());
    }
}

SlopeModel with_islands(IslandPolicy policy) {
    SlopeModel model = rectangle(10, 10);
    add_trace(model, {{2, 2}, {6, 3}, {5, 6}, {2, 2}}, "ring");
    add_trace(model, {{2.75, 3}, {6, 3}}, "ring");
    add_trace(model, {{7, 7}, {9, 7}, {9, 9}, {7, 9}, {7, 7}}, "other");
    add_trace(model, {{7.5, 7.5}, {8.5, 7.5}, {8.5, 8.5}, {7.5, 7.5}}, "inner");
    model.islands = policy;
    return model;
}

TEST(Islands, AreKept) {
    const CutResult result = cut(with_islands(IslandPolicy::keep));
    EXPECT_EQ(result.mesh.block_count(), 5u);
    EXPECT_EQ(result.report.islands, 3u);
    EXPECT_TRUE(island_cuts(cut(rectangle(1, 1)).mesh).empty());
}

TEST(Islands, AreFilledWithAllBlocksInside) {
    const CutResult result = cut(with_islands(IslandPolicy::fill));
    EXPECT_EQ(result.mesh.block_count(), 1u);
    EXPECT_EQ(result.report.merges.filled_islands, 4u);
    EXPECT_EQ(result.mesh.corners.size(), 4u);
    EXPECT_EQ(result.report.domain_area, 100);

    SlopeModel model = rectangle(4, 4);
    model.regions.push_back({"lens", "coal", "contact", {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {}});
    model.islands = IslandPolicy::fill;
    EXPECT_THROW(cut(model), InputError);
}

TEST(Islands, AreConnectedToTheBoundaryByCuts) {
    const CutResult result = cut(with_islands(IslandPolicy::cut));
    EXPECT_EQ(result.report.islands, 0u);
    EXPECT_EQ(result.report.holes, 0u);
    EXPECT_EQ(result.report.island_cuts, 6u);
    EXPECT_EQ(result.report.joints.back().name, "island cut");
    EXPECT_EQ(result.report.joints.back().traces, 6u);
    EXPECT_TRUE(result.report.warnings.empty());
    for (const BlockIndex b : result.mesh.blocks()) EXPECT_EQ(result.mesh.ring_count(b), 1u);
}

TEST(Islands, ATunnelIsNotAnIsland) {
    SlopeModel model = rectangle(10, 10);
    model.tunnels.push_back({"t", {{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}});
    for (const IslandPolicy policy : {IslandPolicy::error, IslandPolicy::cut, IslandPolicy::fill}) {
        model.islands = policy;
        const CutResult result = cut(model);
        EXPECT_EQ(result.report.islands, 0u);
        EXPECT_EQ(result.report.holes, 1u);
        EXPECT_EQ(result.report.domain_area, 96);
    }
}

TEST(Islands, AnIslandThatTouchesTheBoundaryNeedsOneCut) {
    SlopeModel model = rectangle(4, 4);
    add_trace(model, {{0, 0}, {2, 1}, {1, 2}, {0, 0}});
    model.islands = IslandPolicy::cut;
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.island_cuts, 1u);
    EXPECT_EQ(result.report.holes, 0u);
    EXPECT_EQ(result.mesh.block_count(), 3u);  // the cut divides the ring around the island into two blocks
}

struct PolicyCase {
    std::vector<Point> ring;
    std::size_t kept, cut, filled;  ///< blocks by policy
};

// Islands inside; at a corner of the boundary; touching a side in one corner; two that touch each other and
// the boundary.
TEST(Islands, TouchingTheBoundaryUnderEachPolicy) {
    const std::vector<PolicyCase> cases = {
        {{{1, 1}, {3, 1}, {2, 3}, {1, 1}}, 2, 3, 1},
        {{{0, 0}, {2, 1}, {1, 2}, {0, 0}}, 2, 3, 1},
        {{{0, 2}, {2, 1}, {2, 3}, {0, 2}}, 2, 3, 1},
        {{{0, 2}, {1, 1}, {2, 2}, {3, 1}, {3, 3}, {2, 2}, {1, 3}, {0, 2}}, 3, 4, 1},
    };
    for (std::size_t k = 0; k < cases.size(); ++k) {
        SlopeModel model = rectangle(4, 4);
        add_trace(model, cases[k].ring);
        for (const auto& [policy, blocks] :
             {std::pair(IslandPolicy::keep, cases[k].kept), std::pair(IslandPolicy::cut, cases[k].cut),
              std::pair(IslandPolicy::fill, cases[k].filled)}) {
            model.islands = policy;
            const CutResult result = cut(model);
            EXPECT_EQ(result.mesh.block_count(), blocks) << k << ' ' << static_cast<int>(policy);
            EXPECT_EQ(result.report.domain_area, 16);
            EXPECT_EQ(result.report.holes > 0, policy == IslandPolicy::keep) << k;
        }
        model.islands = IslandPolicy::error;
        EXPECT_THROW(cut(model), InputError) << k;
    }
}

TEST(Islands, ATunnelWithABlockAtItsWall) {
    // The first edge of the hole is free and others are joints: it contains an island.
    SlopeModel model = rectangle(10, 10);
    model.tunnels.push_back({"t", {{2, 4}, {4, 4}, {4, 6}, {2, 6}}, {}});
    add_trace(model, {{4, 4}, {6, 5}, {4, 6}}, "wedge");
    EXPECT_EQ(cut(model).report.islands, 1u);
    model.islands = IslandPolicy::fill;
    EXPECT_EQ(cut(model).mesh.block_count(), 1u);
}

/// A square of 8 m with a cross of joints, and a third joint that cuts a chip with two sides of the given
/// length off one of the four blocks of 16 m2.
std::string slope_with_chip(double side, const std::string& small_blocks = "") {
    const std::string a = std::to_string(4 + side);
    return "[domain]\noutline = [[0, 0], [8, 0], [8, 8], [0, 8]]\nblock_material = \"rock\"\n" +
           small_blocks +
           "[[traces]]\njoint_material = \"joint\"\npoints = [[0, 4], [8, 4]]\n"
           "[[traces]]\njoint_material = \"joint\"\npoints = [[4, 0], [4, 8]]\n"
           "[[traces]]\njoint_material = \"joint\"\npoints = [[4, " +
           a + "], [" + a + ", 4]]\n";
}

TEST(SmallBlocks, ChipsAreMergedWithoutTheTable) {
    const CutResult chip = cut(slope(slope_with_chip(.03125)));
    EXPECT_EQ(chip.mesh.block_count(), 4U) << "4.9 cm2, of a limit of 16 cm2";
    EXPECT_TRUE(chip.report.area_proved);
    EXPECT_EQ(chip.report.merges.merged_blocks, 1U);
    EXPECT_EQ(chip.report.merges.largest_merged, .03125 * .03125 / 2);
    EXPECT_EQ(cut(slope(slope_with_chip(.0625))).mesh.block_count(), 5U) << "20 cm2";
    const std::string keep = "[small_blocks]\npolicy = \"keep\"\n";
    EXPECT_EQ(cut(slope(slope_with_chip(.03125, keep))).mesh.block_count(), 5U);
    const std::string larger = "[small_blocks]\npolicy = \"merge\"\nbelow_share = 2e-4\n";
    EXPECT_EQ(cut(slope(slope_with_chip(.0625, larger))).mesh.block_count(), 4U);
}

// A layer of 8 m x 2 cm has a roundness of 0.008.
TEST(SmallBlocks, ThinLayersStayWithoutTheTable) {
    const CutResult result =
        cut(slope("[domain]\noutline = [[0, 0], [8, 0], [8, 8], [0, 8]]\nblock_material = \"rock\"\n"
                  "[[traces]]\njoint_material = \"joint\"\npoints = [[0, 4], [8, 4]]\n"
                  "[[traces]]\njoint_material = \"joint\"\npoints = [[0, 4.02], [8, 4.02]]\n"));
    EXPECT_EQ(result.mesh.block_count(), 3U);
    EXPECT_EQ(result.report.slivers, 1U);
}

TEST(SmallBlocks, KeysOfTheModelFile) {
    const std::string domain =
        "[domain]\noutline = [[0, 0], [2, 0], [2, 1], [0, 1]]\nblock_material = \"rock\"\nislands = "
        "\"fill\"\n";
    const SlopeModel model =
        slope(domain + "[small_blocks]\npolicy = \"drop\"\nbelow_area = 0.5\nbelow_roundness = 0.1\n");
    EXPECT_EQ(model.islands, IslandPolicy::fill);
    EXPECT_EQ(model.small_blocks.policy, SmallBlockPolicy::drop);
    EXPECT_EQ(model.small_blocks.below_area, 0.5);
    EXPECT_EQ(model.small_blocks.below_roundness, 0.1);
    for (const char* bad :
         {"policy = \"melt\"", "policy = \"merge\"\nbelow_area = -1",
          "policy = \"merge\"\nbelow_roundness = 0.7", "below_area = 1", "policy = \"keep\"\nsmaller = 1"})
        EXPECT_THROW(slope(domain + "[small_blocks]\n" + bad + "\n"), InputError) << bad;
}

}  // namespace
}  // namespace rockslope::blockgen::merge_blocks_test
