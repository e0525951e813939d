#include "dda/path/patches.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/random_patch.hpp"

namespace rockslope::patches_test {
namespace {

using namespace rockslope::dda;
using rockslope::random_patch::RandomPatch;

TEST(Patches, LeavesBlocksThatBalance) {
    RandomPatch row(3);
    const std::vector<double> length(row.blocks(), 1.0);
    std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
    EXPECT_EQ(
        Patches()
            .relax(row.step(), {1e3, 0, length, PatchExtent::two_rings, {}}, displacement, ThreadPool(1))
            .patches,
        0);
    for (const Vec6& d : displacement) EXPECT_EQ(d, Vec6::Zero());
}

/// A patch of all blocks ends in balance; a few of a long row lower what is unbalanced.
TEST(Patches, BalanceShortRowsAndLowerTheForcesOfLongOnes) {
    Patches patches;
    int balanced = 0, lowered = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        for (const std::size_t blocks : {4, 40}) {
            RandomPatch row(seed, blocks);
            const std::vector<double> length(blocks, 1.0);
            std::vector<Vec6> displacement(blocks, Vec6::Zero());
            const double before = row.unbalanced(displacement);
            EXPECT_GT(patches
                          .relax(row.step(), {1e-9, 0, length, PatchExtent::two_rings, {}}, displacement,
                                 ThreadPool(1))
                          .patches,
                      0);
            const double after = row.unbalanced(displacement);
            if (blocks == 4) balanced += after < 1e-7 * before ? 1 : 0;
            if (blocks == 40) lowered += after < before ? 1 : 0;
        }
    }
    EXPECT_GE(balanced, 30) << "blocks that nothing presses on are patches of their own";
    EXPECT_GE(lowered, 38);
}

/// All blocks of a row are in one wide patch, and its path ends in balance.
TEST(Patches, WideOnesBalanceLongRows) {
    int balanced = 0, whole = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomPatch row(seed, 40);
        const std::vector<double> length(row.blocks(), 1.0);
        std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
        const double before = row.unbalanced(displacement);
        const PatchAims aims{1e-9, 0, length, PatchExtent::wide, {}};
        whole += Patches().relax(row.step(), aims, displacement, ThreadPool(1)).patches == 1 ? 1 : 0;
        balanced += row.unbalanced(displacement) < 1e-6 * before ? 1 : 0;
    }
    EXPECT_EQ(whole, 40);
    EXPECT_EQ(balanced, 40);
}

/// The path through all blocks is exact: nothing is left behind, as there is by patches that see a part.
TEST(Patches, OneOfAllBlocksLeavesNothing) {
    int balanced = 0, left_by_small_ones = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomPatch row(seed, 40);
        const std::vector<double> length(row.blocks(), 1.0);
        const auto left = [&](PatchExtent extent, int least_patches, int most_patches) {
            std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
            const PatchAims aims{1e-9, 0, length, extent, {}};
            const Relaxation taken = Patches().relax(row.step(), aims, displacement, ThreadPool(1));
            EXPECT_GE(taken.patches, least_patches);
            EXPECT_LE(taken.patches, most_patches);
            return row.unbalanced(displacement) / row.load();
        };
        balanced += left(PatchExtent::all_blocks, 1, 1) < 1e-9 ? 1 : 0;
        left_by_small_ones += left(PatchExtent::two_rings, 2, 40) > 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(balanced, 40) << "to the rounding that a path removes";
    EXPECT_GE(left_by_small_ones, 30);
}

/// Where the path through all blocks is given up they stay where they were, and the relaxation tells.
TEST(Patches, TellOfPathsThatDoNotEnd) {
    RandomPatch row(5, 40);
    const std::vector<double> length(row.blocks(), 1.0);
    std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
    const PatchAims aims{1e-9, 0, length, PatchExtent::all_blocks, {PathStarts::iterate, 1}};
    const Relaxation taken = Patches().relax(row.step(), aims, displacement, ThreadPool(1));
    EXPECT_EQ(taken.failed, 1);
    for (const Vec6& d : displacement) EXPECT_EQ(d, Vec6::Zero());
}

/// A patch that may throw no force on the blocks around it grows to all that press on it, and leaves less
/// behind: what remains is pressed on by blocks that were not in contact.
TEST(Patches, GrowWhereTheyThrowForces) {
    int less = 0, more = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomPatch row(seed, 40);
        const std::vector<double> length(row.blocks(), 1.0);
        const auto left = [&](double most_thrown) {
            std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
            PatchAims aims{1e-9, 0, length, PatchExtent::two_rings, {}};
            aims.most_thrown = most_thrown;
            Patches().relax(row.step(), aims, displacement, ThreadPool(1));
            return row.unbalanced(displacement);
        };
        const double grown = left(0), fixed = left(std::numeric_limits<double>::infinity());
        less += grown < 0.5 * fixed ? 1 : 0;
        more += grown > fixed ? 1 : 0;
    }
    EXPECT_GE(less, 20) << "of 40 rows, less than half of what patches of a fixed size leave";
    EXPECT_LE(more, 8);
}

TEST(Patches, EndWhereTheirVisitsAreUsedUp) {
    RandomPatch row(5, 40);
    const std::vector<double> length(row.blocks(), 1.0);
    const auto relax = [&](double visit_limit) {
        std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
        const PatchAims aims{1e-9, 0, length, PatchExtent::two_rings, {PathStarts::iterate, visit_limit}};
        return Patches().relax(row.step(), aims, displacement, ThreadPool(1));
    };
    const Relaxation whole = relax(std::numeric_limits<double>::infinity());
    ASSERT_GT(whole.patches, 3);
    const Relaxation cut = relax(whole.visits / 2);
    EXPECT_LT(cut.patches, whole.patches);
    EXPECT_LT(cut.visits, 0.75 * whole.visits) << "over the limit by one round at most";
}

/// A long row has many patches in a round, and those that grow come in later ones.
TEST(Patches, MoveTheSameBlocksWithAnyNumberOfThreads) {
    for (const double most_thrown : {0.0, std::numeric_limits<double>::infinity()}) {
        RandomPatch row(5, 400);
        const std::vector<double> length(row.blocks(), 1.0);
        const auto moved = [&](int threads, Relaxation& taken) {
            std::vector<Vec6> displacement(row.blocks(), Vec6::Zero());
            PatchAims aims{1e-9, 0, length, PatchExtent::two_rings, {}};
            aims.most_thrown = most_thrown;
            taken = Patches().relax(row.step(), aims, displacement, ThreadPool(threads));
            return displacement;
        };
        Relaxation alone;
        const std::vector<Vec6> by_one = moved(1, alone);
        EXPECT_GT(alone.patches, 20);
        for (const int threads : {2, 5}) {
            Relaxation taken;
            EXPECT_EQ(moved(threads, taken), by_one) << threads;
            EXPECT_EQ(taken.visits, alone.visits);
            EXPECT_EQ(taken.borders, alone.borders);
        }
    }
}

}  // namespace
}  // namespace rockslope::patches_test
