// A block on a floor, in one step of 0.01 s under loads whose solution is known: a block that neither rotates
// nor strains has, in each direction, 2 m / dt^2 for its inertia and 2 k for its springs.

#include "dda/solve/open_close_iteration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/resting_block.hpp"

namespace rockslope::open_close_iteration_test {
namespace {

using namespace scene;
using dda::ContactState;

constexpr double dt = 0.01;
constexpr double inertia = 2 * 2500 / (dt * dt);  // N/m
constexpr double spring = RestingContacts::spring;

/// The block's step under a force at the middle of its bottom: along the tangent and into the floor, N.
struct LoadedBlock {
    FirstStep step;
    dda::OpenCloseResult result;
    dda::PerRow<Vec6> found;  ///< by an earlier attempt

    LoadedBlock(const Scene& s, double along, double into) : step(s.model) {
        step.base.stiffness[0].setZero();
        dda::add_inertia(step.rows, step.state.blocks, {0.5, 1, dt}, 0, step.base);
        step.base.stiffness[0].diagonal().tail<4>().array() += 1e20;  // neither rotates nor strains
        step.base.load[0] = dda::project(Vec2(-along, -into), Vec2(0, -0.5));
    }
    void iterate(int iteration_limit = 100, const dda::StepTime& time = dda::StepTime(1),
                 dda::Beginning beginning = dda::Beginning::in_patches) {
        step.control.iteration_limit = iteration_limit;
        dda::StepProblem problem = step.problem();
        problem.time = time;
        problem.found = found;
        dda::IterationWorkspace work;
        const auto solver = dda::make_linear_solver(dda::SolverKind::multifrontal, step.pool);
        solver->analyze(step.pattern);
        result = dda::iterate_open_close(problem, beginning, step.pattern, *solver, work, step.pool).result;
    }
    double moved_along() const { return -result.displacement[0][0]; }
    double moved_into() const { return -result.displacement[0][1]; }
};

TEST(OpenCloseIteration, ClosesAndLocksTheContactsOfARestingBlock) {
    LoadedBlock block(resting_block(Scene::mohr_coulomb(30)), 1e3, 5e4);
    block.iterate();
    ASSERT_TRUE(block.result.converged);
    EXPECT_NEAR(block.moved_into(), 5e4 / (inertia + 2 * spring), 1e-12);
    EXPECT_NEAR(block.moved_along(), 1e3 / (inertia + 2 * spring), 1e-12);
    for (const dda::EvaluatedContact& contact : block.result.contacts) {
        EXPECT_EQ(contact.state, ContactState::locked);
        EXPECT_NEAR(contact.normal_force, spring * block.moved_into(), 1e-3);
        EXPECT_NEAR(contact.shear_force, spring * block.moved_along(), 1e-3);
    }
}

// The friction of both contacts is N tan 30, N the force of the normal springs: the rest accelerates the
// block.
TEST(OpenCloseIteration, LetsABlockSlideUnderMoreThanItsFriction) {
    for (const double direction : {1.0, -1.0}) {
        LoadedBlock block(resting_block(Scene::mohr_coulomb(30)), direction * 8e4, 5e4);
        block.iterate();
        ASSERT_TRUE(block.result.converged);
        const double friction = 2 * spring * 5e4 / (inertia + 2 * spring) * std::tan(radians(30));
        EXPECT_NEAR(block.moved_along(), direction * (8e4 - friction) / inertia, 1e-9);
        for (const dda::EvaluatedContact& contact : block.result.contacts) {
            EXPECT_EQ(contact.state, ContactState::sliding);
            EXPECT_NEAR(contact.shear_force, direction * friction / 2, 0.1);
            EXPECT_NEAR(contact.slip, block.moved_along() - contact.shear_force / spring, 1e-12);
        }
    }
}

// The block begins locked and slides in the patch. A static step takes that; a dynamic one solves the linear
// system of the sliding block as well.
TEST(OpenCloseIteration, AcceptsTheBalanceOfPatchesInAStaticStep) {
    const Scene s = resting_block(Scene::mohr_coulomb(30));
    LoadedBlock at_rest(s, 8e4, 5e4), moving(s, 8e4, 5e4);
    at_rest.iterate(100, {});
    moving.iterate(100, dda::StepTime(dt));
    ASSERT_TRUE(at_rest.result.converged && moving.result.converged);
    EXPECT_EQ(at_rest.result.iterations, 1);
    EXPECT_EQ(moving.result.iterations, 2);
    EXPECT_NEAR(at_rest.moved_along(), moving.moved_along(), 1e-9);
}

TEST(OpenCloseIteration, OpensTheContactsOfARisingBlock) {
    LoadedBlock block(resting_block(Scene::mohr_coulomb(30)), 1e3, -5e4);
    block.iterate();
    ASSERT_TRUE(block.result.converged);
    EXPECT_NEAR(block.moved_into(), -5e4 / inertia, 1e-12);
    EXPECT_NEAR(block.moved_along(), 1e3 / inertia, 1e-12);
    for (const dda::EvaluatedContact& contact : block.result.contacts) {
        EXPECT_EQ(contact.state, ContactState::open);
        EXPECT_EQ(contact.normal_force, 0);
    }
}

// Bonds of 5e4 Pa over 0.5 m bear 25 kN each. Under 49 kN they hold, under 60 kN they break in this step, and
// the block rises as if there had been none.
TEST(OpenCloseIteration, BreaksBondsAndSolvesAgain) {
    const Scene bonded = resting_block(dda::MohrCoulomb{radians(30), 1e5, 5e4, radians(30), 0});
    LoadedBlock held(bonded, 0, -4.9e4);
    held.iterate();
    ASSERT_TRUE(held.result.converged);
    EXPECT_NEAR(held.moved_into(), -4.9e4 / (inertia + 2 * spring), 1e-12);
    EXPECT_FALSE(held.result.contacts[0].bond_broken);

    LoadedBlock torn(bonded, 0, -6e4);
    torn.iterate();
    ASSERT_TRUE(torn.result.converged);
    EXPECT_NEAR(torn.moved_into(), -6e4 / inertia, 1e-12);
    for (const dda::EvaluatedContact& contact : torn.result.contacts) EXPECT_TRUE(contact.bond_broken);
}

// Augmented contacts are rigid: the block does not get into the floor by more than the tolerance, and the
// contacts bear what inertia does not.
TEST(OpenCloseIteration, AugmentsForcesUntilThePenetrationIsWithinTheTolerance) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.penetration_tolerance = 1e-9;
    LoadedBlock block(s, 0, 5e4);
    block.iterate(100, dda::StepTime(1), dda::Beginning::along_lines);
    ASSERT_TRUE(block.result.converged);
    EXPECT_LE(std::abs(block.moved_into()), 1e-9);
    for (const dda::EvaluatedContact& contact : block.result.contacts)
        EXPECT_NEAR(contact.normal_force, 2.5e4, inertia * 1e-9);
}

TEST(OpenCloseIteration, AddsTheForceOfABolt) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.bolts.push_back(
        {"bolt", s.material_point(0, {0.5, -0.5}), s.material_point(1, {0.5, 0.5}), 1e7, 0, 2e4});
    LoadedBlock elastic(s, 0, -5e4), yielding(s, 0, -5e5);
    elastic.iterate();
    ASSERT_TRUE(elastic.result.converged);
    EXPECT_NEAR(elastic.moved_into(), -5e4 / (inertia + 1e7), 1e-12);
    EXPECT_NEAR(elastic.result.bolt_force[0], 1e7 * 5e4 / (inertia + 1e7), 1e-4);
    yielding.iterate();
    ASSERT_TRUE(yielding.result.converged);
    EXPECT_NEAR(yielding.moved_into(), -(5e5 - 2e4) / inertia, 1e-12);
    EXPECT_EQ(yielding.result.bolt_force[0], 2e4);
}

// One iteration finds that the contacts open, whose springs pulled; another one has to solve without them.
TEST(OpenCloseIteration, SaysWhichContactDoesNotConverge) {
    LoadedBlock block(resting_block(Scene::mohr_coulomb(30)), 0, -5e4);
    block.iterate(1);
    EXPECT_FALSE(block.result.converged);
    EXPECT_FALSE(block.result.singular);
    EXPECT_EQ(block.result.iterations, 1);
    EXPECT_TRUE(block.result.worst_contact.exists());
    const double pulled = spring * 5e4 / (inertia + 2 * spring);
    EXPECT_NEAR(block.result.force_change, pulled, 1e-6 * pulled);
}

TEST(OpenCloseIteration, SaysThatTheMatrixIsNotPositiveDefinite) {
    LoadedBlock block(resting_block(Scene::mohr_coulomb(30)), 0, -5e4);
    block.step.base.stiffness[0].setZero();
    block.iterate();
    EXPECT_FALSE(block.result.converged);
    EXPECT_TRUE(block.result.singular);
}

// The answer does not depend on the guess, only the work does.
TEST(OpenCloseIteration, NeedsFewerIterationsFromAGoodGuess) {
    const Scene s = resting_block(Scene::mohr_coulomb(30));
    LoadedBlock first(s, 8e4, 5e4), second(s, 8e4, 5e4);
    first.iterate();
    ASSERT_TRUE(first.result.converged);
    for (std::size_t k = 0; k < 2; ++k) second.step.guess[k] = &first.result.contacts[dda::ContactIndex(k)];
    second.iterate();
    ASSERT_TRUE(second.result.converged);
    EXPECT_LT(second.result.iterations, first.result.iterations);
    EXPECT_NEAR(second.moved_along(), first.moved_along(), 1e-9 * first.moved_along());
}

// The guess says that both contacts are open, and lets the block through the floor; where it was found says
// that they bear it.
TEST(OpenCloseIteration, BeginsWhereAnEarlierAttemptEnded) {
    const Scene s = resting_block(Scene::mohr_coulomb(30));
    LoadedBlock first(s, 8e4, 5e4), from_guess(s, 8e4, 5e4), from_found(s, 8e4, 5e4);
    first.iterate();
    ASSERT_TRUE(first.result.converged);
    const dda::EvaluatedContact open;
    for (LoadedBlock* again : {&from_guess, &from_found})
        for (std::size_t k = 0; k < 2; ++k) again->step.guess[k] = &open;
    from_found.found = first.result.displacement;
    from_guess.iterate();
    from_found.iterate();
    ASSERT_TRUE(from_guess.result.converged && from_found.result.converged);
    EXPECT_EQ(from_found.result.iterations, 1);
    EXPECT_GT(from_guess.result.iterations, 1);
    EXPECT_NEAR(from_found.moved_along(), first.moved_along(), 1e-9 * first.moved_along());
    EXPECT_NEAR(from_found.moved_into(), first.moved_into(), 1e-9 * first.moved_into());
}

}  // namespace
}  // namespace rockslope::open_close_iteration_test
