#include "dda/solve/methods/patch_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "support/resting_block.hpp"

namespace rockslope::patch_balance_test {
namespace {

using namespace scene;

/// A block of 1 m on a floor under a load of 30 kN along it and 50 kN into it, balanced in a patch. Its own
/// stiffness is 1e8 N/m.
struct Balance {
    RestingContacts contacts;
    dda::PatchBalance::Memory memory;
    dda::PatchBalance patches{contacts.problem, contacts.contacts, memory, contacts.step.pool};
    dda::PerRow<Vec6> displacement{1, RestingContacts::displacement(0, 1e-5)};

    explicit Balance(double friction_angle) : contacts(Scene::mohr_coulomb(friction_angle)) {
        contacts.step.base.stiffness[0] *= 1e8;
        contacts.step.base.load[0] = dda::project(Vec2(-3e4, -5e4), Vec2(0, -0.5));
        contacts.trials.set_displacement(displacement, displacement);
        contacts.bounds.update();
        contacts.trials.force_change();  // sets the tolerance
    }
    bool relax() { return patches.relax(1, displacement); }
};

TEST(PatchBalance, OfABlockThatStandsOrSlides) {
    for (const double friction_angle : {20.0, 40.0}) {
        Balance block(friction_angle);
        ASSERT_TRUE(block.relax());
        EXPECT_TRUE(block.patches.is_complete(block.displacement)) << friction_angle;
        EXPECT_FALSE(block.relax()) << "nothing is left to balance";
        const dda::PerRow<Vec6> start(1, Vec6::Zero());
        EXPECT_FALSE(block.patches.is_complete(start)) << "out of balance there";
    }
}

// Two springs of 1e9 N/m bear what the block does not: at its bottom 8e7 N/m, from its vertical motion and
// its strain with an arm of 0.5 m.
TEST(PatchBalance, GivesTheForcesThatTheLawsHaveThere) {
    Balance block(20);
    block.relax();
    ASSERT_TRUE(block.patches.is_complete(block.displacement));
    block.contacts.trials.move_to(block.displacement);
    block.contacts.bounds.update();
    EXPECT_LT(block.contacts.trials.force_change().largest, 1e-6) << "N";
    double normal = 0;
    for (const dda::EvaluatedContact& contact : block.contacts.evaluated()) normal += contact.normal_force;
    EXPECT_NEAR(normal, 5e4 * 2e9 / 2.08e9, 1e-3);
}

TEST(PatchBalance, LeadsAstrayWhereForceChangesGrow) {
    Balance block(20);
    EXPECT_FALSE(block.patches.leads_astray(1, 10));
    EXPECT_FALSE(block.patches.leads_astray(2, 1000)) << "a hundred times the first";
    EXPECT_TRUE(block.patches.leads_astray(2, 1001));
    EXPECT_TRUE(block.patches.leads_astray(3, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_TRUE(block.patches.leads_astray(dda::PatchBalance::iterations, 10)) << "one patch takes over";
    block.contacts.problem.time = dda::StepTime();
    EXPECT_FALSE(block.patches.leads_astray(dda::PatchBalance::iterations, 10));
    EXPECT_TRUE(block.patches.leads_astray(dda::PatchBalance::iterations, 11)) << "no smaller at the end";
}

// From a displacement that an earlier attempt balanced the first force change is next to nothing.
TEST(PatchBalance, FromABalancedStartComparesWithTheSecondForceChange) {
    Balance block(20);
    block.patches.relax(0, block.displacement);
    EXPECT_FALSE(block.patches.leads_astray(1, 1e-3));
    EXPECT_FALSE(block.patches.leads_astray(2, 10));
    EXPECT_FALSE(block.patches.leads_astray(3, 1000));
    EXPECT_TRUE(block.patches.leads_astray(3, 1001));
}

// The corners of the block of 1 m may go 1 mm, as in the step: it moves as far, or turns about its centroid,
// from which they are 0.707 m away.
TEST(PatchBalance, ThrewABlockThatIsFartherThanTheLimit) {
    Balance block(20);
    block.contacts.problem.displacement_limit = 1e-3;
    for (const auto& [unknown, arm] : {std::pair{0, 1.0}, {1, 1.0}, {2, std::sqrt(0.5)}}) {
        dda::PerRow<Vec6> displacement(1, Vec6::Zero());
        displacement[dda::RowIndex(0)][unknown] = -0.99e-3 / arm;
        EXPECT_FALSE(block.patches.threw_a_block(displacement)) << unknown;
        displacement[dda::RowIndex(0)][unknown] = -1.01e-3 / arm;
        EXPECT_TRUE(block.patches.threw_a_block(displacement)) << unknown;
    }
}

// Out of balance by 30 kN and more at first, and by nothing where the patch has balanced the block.
TEST(PatchBalance, KnowsTheDisplacementNearestToBalance) {
    Balance block(20);
    block.contacts.problem.time = dda::StepTime(0.005);
    const dda::PerRow<Vec6> first = block.displacement;
    block.relax();
    EXPECT_EQ(block.patches.nearest()[dda::RowIndex(0)], first[dda::RowIndex(0)]) << "before it was balanced";
    const dda::PerRow<Vec6> balanced = block.displacement;
    block.relax();
    EXPECT_EQ(block.patches.nearest()[dda::RowIndex(0)], balanced[dda::RowIndex(0)]);
    block.displacement[dda::RowIndex(0)] *= 2;
    block.relax();
    EXPECT_EQ(block.patches.nearest()[dda::RowIndex(0)], balanced[dda::RowIndex(0)]) << "nearer";
}

TEST(PatchBalance, KnowsNoNearestDisplacementInAStaticStep) {
    Balance block(20);
    block.contacts.problem.time = dda::StepTime();
    block.relax();
    EXPECT_TRUE(block.patches.nearest().empty());
}

// One patch of all blocks balances them to rounding: forces may change as much as they will on the way.
TEST(PatchBalance, InOnePatchLeadsAstrayAtItsEndOnly) {
    Balance block(20);
    block.patches.join_all();
    ASSERT_TRUE(block.relax());
    EXPECT_TRUE(block.patches.is_complete(block.displacement));
    EXPECT_FALSE(block.patches.leads_astray(1, 10));
    EXPECT_FALSE(block.patches.leads_astray(2, 1e6));
    EXPECT_TRUE(block.patches.leads_astray(2, std::numeric_limits<double>::infinity()));
    EXPECT_TRUE(block.patches.leads_astray(dda::PatchBalance::iterations, 1));
}

TEST(PatchBalance, MayBeOnePatchInADynamicStep) {
    Balance block(20);
    dda::StepProblem problem(block.contacts.problem);
    problem.time = dda::StepTime(0.005);
    EXPECT_TRUE(dda::PatchBalance::suits_one_patch(problem));
    problem.time = dda::StepTime();
    EXPECT_FALSE(dda::PatchBalance::suits_one_patch(problem)) << "static";
}

}  // namespace
}  // namespace rockslope::patch_balance_test
