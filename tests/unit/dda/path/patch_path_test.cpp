#include "dda/path/patch_path.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/pressed_block.hpp"
#include "support/random_patch.hpp"

namespace rockslope::patch_path_test {
namespace {

using namespace rockslope::dda;
using rockslope::pressed_block::PressedBlock;
using rockslope::random_patch::RandomPatch;

/// The displacement at the end of the path from no displacement, m.
Vec6 end_of_path(const PressedBlock& block, PatchPath::Outcome& outcome) {
    std::vector<Vec6> displacement{Vec6::Zero()};
    std::vector<ElasticForces> elastic{block.contact.elastic_at(displacement)};
    const std::vector<RowIndex> patch{RowIndex(0)};
    outcome = PatchPath().follow(block.step(), patch, {displacement, elastic}, PathAims{});
    return displacement[0];
}

TEST(PatchPath, FindsBlockThatSticks) {
    PatchPath::Outcome outcome;
    const Vec6 d = end_of_path(PressedBlock(30), outcome);
    EXPECT_TRUE(outcome.balanced);
    EXPECT_NEAR(d[1], -100 / (1e6 + 1e3), 1e-15);
    EXPECT_NEAR(d[0], 30 / (4e5 + 1e3), 1e-15);
}

TEST(PatchPath, FindsBlockThatSlides) {
    PatchPath::Outcome outcome;
    const Vec6 d = end_of_path(PressedBlock(80), outcome);
    EXPECT_TRUE(outcome.balanced);
    const double normal = 1e6 * 100 / (1e6 + 1e3);
    EXPECT_NEAR(d[0], (80 - 0.5 * normal) / 1e3, 1e-12);
    EXPECT_GE(outcome.borders, 1);
}

/// The load of a patch that hangs together by nothing but its contacts cannot be borne: none is found, and
/// nothing changes.
TEST(PatchPath, LeavesWhatCannotBalance) {
    PressedBlock block(80);
    block.base.stiffness[RowIndex(0)].setZero();
    std::vector<Vec6> displacement{Vec6::Constant(1e-3)};
    std::vector<ElasticForces> elastic{block.contact.elastic_at(displacement)};
    const ElasticForces before = elastic[0];
    const std::vector<RowIndex> patch{RowIndex(0)};
    EXPECT_FALSE(PatchPath().follow(block.step(), patch, {displacement, elastic}, PathAims{}).balanced);
    EXPECT_EQ(displacement[0], Vec6::Constant(1e-3));
    EXPECT_EQ(elastic[0].normal, before.normal);
    EXPECT_EQ(elastic[0].shear, before.shear);
}

/// Random blocks in contact, of which many slide or part on the way, from random displacements.
TEST(PatchPath, BalancesRandomPatches) {
    PatchPath path;
    int begun_negative = 0, begun_apart = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        RandomPatch patch(seed);
        const std::vector<Vec6> start = patch.random_displacement();
        std::vector<Vec6> displacement = start;
        std::vector<ElasticForces> elastic = patch.elastic(displacement);
        const bool is_negative = patch.determinant_sign(displacement) < 0;
        const PatchPath::Outcome outcome =
            path.follow(patch.step(), patch.rows(), {displacement, elastic}, PathAims{});
        EXPECT_TRUE(outcome.balanced) << "seed " << seed;
        begun_apart += outcome.began_apart ? 1 : 0;
        begun_negative += is_negative ? 1 : 0;
        EXPECT_LT(patch.unbalanced(displacement), 1e-6 * patch.load())
            << "rounding, where a border is near; seed " << seed;
        const std::vector<ElasticForces> here = patch.elastic(displacement);
        for (std::size_t k = 0; k < elastic.size(); ++k) {
            EXPECT_NEAR(elastic[k].normal, here[k].normal, 1e-6 * patch.load());
            EXPECT_NEAR(elastic[k].shear, here[k].shear, 1e-6 * patch.load());
        }
    }
    EXPECT_GT(begun_apart, 4) << "some paths from the iterate close on themselves";
    EXPECT_GT(begun_negative, 10) << "against the direction of a positive determinant these would run away";
}

/// Follows the path from the iterate alone in 2000 random patches; calls visit(patch, start, outcome) where
/// it does not arrive.
template <class Visit>
void for_paths_that_do_not_arrive(const Visit& visit) {
    PatchPath path;
    const PathAims alone{PathStarts::iterate, std::numeric_limits<double>::infinity(), 10'000};
    for (unsigned seed = 0; seed < 2000; ++seed) {
        RandomPatch patch(seed);
        const std::vector<Vec6> start = patch.random_displacement();
        std::vector<Vec6> displacement = start;
        std::vector<ElasticForces> elastic = patch.elastic(displacement);
        const PatchPath::Outcome outcome =
            path.follow(patch.step(), patch.rows(), {displacement, elastic}, alone);
        if (!outcome.balanced) visit(patch, start, outcome);
    }
}

/// Such a path closes on itself, after fewer borders than the patch has contacts; it does not go round up to
/// its limit.
TEST(PatchPath, EndsWhereItComesBackToItsStart) {
    int closed = 0;
    for_paths_that_do_not_arrive(
        [&](const RandomPatch& patch, const std::vector<Vec6>&, const PatchPath::Outcome& outcome) {
            EXPECT_LT(outcome.borders, 3 * static_cast<int>(patch.step().contacts.size()));
            ++closed;
        });
    EXPECT_GT(closed, 4);
}

/// With the contacts open that led it round, another path arrives: in all but two of these patches.
TEST(PatchPath, BeginsWithTheContactsOpenThatLedItRound) {
    PatchPath path;
    const PathAims crossed{.starts = PathStarts::iterate_then_crossed_apart};
    int arrived = 0, left = 0;
    for_paths_that_do_not_arrive([&](RandomPatch& patch, const std::vector<Vec6>& start,
                                     const PatchPath::Outcome& alone) {
        std::vector<Vec6> displacement = start;
        std::vector<ElasticForces> elastic = patch.elastic(displacement);
        const PatchPath::Outcome outcome =
            path.follow(patch.step(), patch.rows(), {displacement, elastic}, crossed);
        EXPECT_GT(outcome.borders, alone.borders) << "those of all paths count";
        if (!outcome.balanced) {
            EXPECT_EQ(displacement, start);
            ++left;
            return;
        }
        EXPECT_TRUE(outcome.began_apart);
        EXPECT_LT(patch.unbalanced(displacement), 1e-6 * patch.load()) << "rounding, where a border is near";
        ++arrived;
    });
    EXPECT_GT(arrived, 4);
    EXPECT_LE(left, 2);
}

/// Contacts between a patch in a row and the blocks around it.
TEST(PatchPath, TellsTheForceThatItThrowsOnBlocksAround) {
    int thrown = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        RandomPatch row(seed, 12);
        std::vector<Vec6> displacement = row.random_displacement();
        std::vector<ElasticForces> elastic = row.elastic(displacement);
        const std::vector<ElasticForces> before = elastic;
        const std::vector<RowIndex> patch{RowIndex(4), RowIndex(5), RowIndex(6)};
        const auto is_inside = [&](RowIndex block) {
            return std::find(patch.begin(), patch.end(), block) != patch.end();
        };
        const PatchPath::Outcome outcome =
            PatchPath().follow(row.step(), patch, {displacement, elastic}, PathAims{});
        if (!outcome.balanced) continue;
        double largest = 0;
        for (std::size_t k = 0; k < before.size(); ++k) {
            const LimitedContact& contact = row.step().contacts[ContactIndex(k)];
            const auto& [first, second] = std::pair(contact.rows->first, contact.rows->second);
            if (!first.exists() || !second.exists() || is_inside(first) == is_inside(second)) continue;
            const auto force = [&](const ElasticForces& at) {
                return Vec2(contact.on(contact.piece_at(at)).at(at));
            };
            largest = std::max(largest, (force(elastic[k]) - force(before[k])).cwiseAbs().maxCoeff());
        }
        EXPECT_NEAR(outcome.thrown, largest, 1e-9 * row.load()) << "seed " << seed;
        thrown += largest > 0 ? 1 : 0;
    }
    EXPECT_GT(thrown, 50);
}

/// Follows the path of a random patch, which leaves its displacement as it was where it is given up.
PatchPath::Outcome follow(const RandomPatch& patch, const std::vector<Vec6>& start, const PathAims& aims) {
    std::vector<Vec6> displacement = start;
    std::vector<ElasticForces> elastic = patch.elastic(displacement);
    const PatchPath::Outcome outcome =
        PatchPath().follow(patch.step(), patch.rows(), {displacement, elastic}, aims);
    EXPECT_EQ(displacement == start, !outcome.balanced);
    return outcome;
}

/// The least number of visits that leads to balance: so many contacts for each border, and once more.
TEST(PatchPath, IsGivenUpWhereItsVisitsAreUsedUp) {
    RandomPatch patch(1, 40);
    const std::vector<Vec6> start = patch.random_displacement();
    const auto within = [&](double visit_limit) {
        return follow(patch, start, PathAims{PathStarts::iterate, visit_limit});
    };
    const PatchPath::Outcome whole = within(std::numeric_limits<double>::infinity());
    ASSERT_TRUE(whole.balanced);
    ASSERT_GT(whole.borders, 5);
    const double contacts = whole.visits / (whole.borders + 1);
    EXPECT_EQ(contacts, std::floor(contacts));
    EXPECT_TRUE(within(whole.visits).balanced);
    const PatchPath::Outcome cut = within(whole.visits - contacts);
    EXPECT_FALSE(cut.balanced);
    EXPECT_EQ(cut.borders, whole.borders);
}

/// The path is given up at the first border beyond the limit, and nothing changes.
TEST(PatchPath, IsGivenUpAtItsLimitOfBorders) {
    RandomPatch patch(1, 40);
    const std::vector<Vec6> start = patch.random_displacement();
    const auto within = [&](int border_limit) {
        return follow(patch, start,
                      {PathStarts::iterate, std::numeric_limits<double>::infinity(), border_limit});
    };
    const PatchPath::Outcome whole = within(1000);
    ASSERT_TRUE(whole.balanced);
    EXPECT_TRUE(within(whole.borders + 1).balanced);
    const PatchPath::Outcome cut = within(whole.borders - 1);
    EXPECT_FALSE(cut.balanced);
    EXPECT_EQ(cut.borders, whole.borders - 1);
}

}  // namespace
}  // namespace rockslope::patch_path_test
