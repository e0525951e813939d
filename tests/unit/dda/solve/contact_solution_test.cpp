#include "dda/solve/contact_solution.hpp"

#include <gtest/gtest.h>

#include "support/resting_block.hpp"

namespace rockslope::contact_solution_test {
namespace {

using namespace scene;
using dda::Beginning;

/// How a step of a block on a floor, dynamic or static, begins anew.
class NextBeginning : public testing::Test {
  protected:
    std::optional<dda::StepBeginning> next(const dda::StepBeginning& begun,
                                           const dda::IterationOutcome& outcome) const {
        dda::StepProblem problem = step_.problem();
        if (is_static_) problem.time = {};
        return dda::next_beginning(problem, begun, outcome);
    }
    /// Patches that led astray, and came near to balance at a displacement of 3 mm.
    static dda::IterationOutcome astray() {
        dda::IterationOutcome outcome;
        outcome.went_astray = true;
        outcome.nearest = near();
        return outcome;
    }
    static dda::IterationOutcome threw_a_block() {
        dda::IterationOutcome outcome = astray();
        outcome.result.gaps_unsettled = true;
        return outcome;
    }
    static dda::PerRow<Vec6> near() { return {Vec6::Constant(3e-3)}; }

    FirstStep step_{resting_block(Scene::mohr_coulomb(30)).model};
    bool is_static_ = false;
};

TEST_F(NextBeginning, IsNoneAfterAnIterationThatDidNotGoAstray) {
    for (const bool converged : {false, true}) {
        dda::IterationOutcome outcome;
        outcome.result.converged = converged;
        EXPECT_FALSE(next({}, outcome));
    }
}

TEST_F(NextBeginning, IsOnePatchWhereThePatchesWereNearest) {
    const auto begun = next({}, astray());
    ASSERT_TRUE(begun);
    EXPECT_EQ(begun->beginning, Beginning::in_one_patch);
    EXPECT_EQ(begun->found, near());
}

TEST_F(NextBeginning, IsOnePatchAtTheLinearSolutionWhereThePatchesThrewABlock) {
    const auto begun = next({}, threw_a_block());
    ASSERT_TRUE(begun);
    EXPECT_EQ(begun->beginning, Beginning::in_one_patch);
    EXPECT_TRUE(begun->found.empty());
}

TEST_F(NextBeginning, IsTheLinearSolutionWhereOnePatchThrewABlockFromTheNearestDisplacement) {
    const dda::StepBeginning nearest{Beginning::in_one_patch, near()};
    const auto begun = next(nearest, threw_a_block());
    ASSERT_TRUE(begun);
    EXPECT_EQ(begun->beginning, Beginning::in_one_patch);
    EXPECT_TRUE(begun->found.empty());
    EXPECT_FALSE(next(*begun, threw_a_block())) << "there is no fourth";
    EXPECT_FALSE(next(nearest, astray())) << "its path was given up";
}

TEST_F(NextBeginning, IsAlongLinesInAStaticStep) {
    is_static_ = true;
    dda::IterationOutcome outcome = astray();
    outcome.nearest.clear();
    const auto begun = next({}, outcome);
    ASSERT_TRUE(begun);
    EXPECT_EQ(begun->beginning, Beginning::along_lines);
    EXPECT_TRUE(begun->found.empty());
    EXPECT_FALSE(next(*begun, threw_a_block()));
}

}  // namespace
}  // namespace rockslope::contact_solution_test
