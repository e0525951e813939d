#include "dda/analysis/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/analysis/step.hpp"
#include "support/walls.hpp"

namespace rockslope::run_test {
namespace {

using namespace scene;

bool all_finite(const dda::State& state) {
    const dda::BlockSystem& b = state.blocks;
    const auto finite = [](const auto& v) { return v.allFinite(); };
    return std::all_of(b.vertices.begin(), b.vertices.end(), finite) &&
           std::all_of(b.velocity.begin(), b.velocity.end(), finite) &&
           std::all_of(b.stress.begin(), b.stress.end(), finite) && std::isfinite(state.energy.residual());
}

/// Two blocks that meet at 20 m/s.
struct Crash {
    Scene s;
    Crash() {
        s.box({0, 0}, 1, 1);
        s.box({1.05, .1}, 1, 1);
        s.model.initial_velocity = {(Vec6() << 10, 0, 0, 0, 0, 0).finished(),
                                    (Vec6() << -10, 0, 0, 0, 0, 0).finished()};
    }
};

// A body falls by 20 m in two seconds, but a step may move a vertex of this wall by 0.11 m only. The search
// radius must not exceed that: otherwise a large model would have thousands of candidates for each block.
TEST(Run, SearchRadiusOfALongStaticStepIsLimited) {
    const Scene s = running_bond_wall(10, 21, 10);
    const dda::State state = dda::initial_state(s.model);
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    dda::TimeStepper stepper(s.model, 1);
    const dda::StepAttempt attempt = stepper.advance(stage, state, 2);
    ASSERT_EQ(attempt.rejection, dda::Rejection::none);
    const double admitted = stage.control.displacement_ratio * 22 / 2;
    EXPECT_LT(attempt.report.largest_displacement, admitted);
    EXPECT_LT(attempt.state.contacts.candidate_distance, 2 * (2 * admitted + .01));
}

// An overflowing load gives a displacement that is not finite: the step must be rejected at any size.
TEST(Run, RejectsADisplacementThatIsNotFinite) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.model.gravity = {0, -1e308};
    Simulation sim(s);
    dda::Stage stage;
    stage.duration = .1;
    stage.control = {.step = 1e-3, .smallest_step = 5e-4};
    EXPECT_EQ(sim.run(stage).status, dda::RunStatus::not_converged);
    EXPECT_TRUE(all_finite(sim.state));
    EXPECT_TRUE(sim.reports.empty());
}

// One iteration does not suffice to close a contact, and the step can be cut only once. The run must end with
// the reason and with the last accepted state.
TEST(Run, EndsWithTheReasonWhereNoStepConverges) {
    const Crash crash;
    Simulation sim(crash.s);
    dda::Stage stage;
    stage.name = "crash";
    stage.duration = .1;
    stage.control = {.step = 1e-3, .smallest_step = 5e-4, .iteration_limit = 1, .displacement_ratio = 1};
    const dda::RunOutcome outcome = sim.run(stage);
    EXPECT_EQ(outcome.status, dda::RunStatus::not_converged);
    EXPECT_NE(outcome.message.find("stage 'crash', t = "), std::string::npos) << outcome.message;
    EXPECT_NE(outcome.message.find("worst contact: block"), std::string::npos) << outcome.message;
    EXPECT_EQ(outcome.message.find('\n'), std::string::npos);
    EXPECT_TRUE(all_finite(sim.state));
    ASSERT_FALSE(sim.reports.empty());
    EXPECT_EQ(sim.state.time, sim.reports.back().time) << "the last accepted step";
    EXPECT_LT(sim.state.time, .1);
}

TEST(Run, EndsWithTheReasonWhereBlocksAreTooFast) {
    const Crash crash;
    Simulation sim(crash.s);
    dda::Stage stage;
    stage.name = "fast";
    stage.duration = .1;
    stage.control = {.step = 1e-3, .smallest_step = 5e-4};
    const dda::RunOutcome outcome = sim.run(stage);
    EXPECT_EQ(outcome.status, dda::RunStatus::not_converged);
    EXPECT_NE(outcome.message.find("a vertex moves 0.01 m"), std::string::npos) << outcome.message;
    EXPECT_TRUE(sim.reports.empty());
}

// Coordinates of 2 m have a rounding error of 3.6e-15 m in a step. A spring of 1e18 N/m turns it into 3.6 kN,
// for a block of 24.5 kN: any state would pass for equilibrium. A spring of 1e15 N/m must be accepted.
TEST(Run, EndsWithTheReasonWhereSpringsAreTooStiffForRounding) {
    for (const double stiffness : {1e18, 1e15}) {
        Scene s;
        s.friction(35);
        s.model.shear_penalty = stiffness;
        s.box({0, 0}, 2, 1, dda::Motion::fixed);
        s.box({.5, 1}, 1, 1);
        Simulation sim(s);
        const dda::RunOutcome outcome = sim.settle();
        if (stiffness < 1e18) {
            EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
            continue;
        }
        EXPECT_EQ(outcome.status, dda::RunStatus::not_converged);
        EXPECT_NE(outcome.message.find("springs are too stiff"), std::string::npos) << outcome.message;
    }
}

TEST(Run, CompletesTheSameModelWithDefaultControl) {
    const Crash crash;
    Simulation sim(crash.s);
    EXPECT_EQ(sim.shake(.02, 1e-3).status, dda::RunStatus::completed);
    EXPECT_TRUE(all_finite(sim.state));
    EXPECT_GT(sim.state.blocks.centroid(1).x(), sim.state.blocks.centroid(0).x())
        << "the blocks must not pass through each other";
}

TEST(Run, ReportsThatAFallingBlockDoesNotSettle) {
    Scene s;
    s.box({0, 0}, 1, 1);
    Simulation sim(s);
    dda::Stage stage;
    stage.name = "settle";
    stage.kind = dda::StageKind::static_equilibrium;
    stage.step_limit = 20;
    const dda::RunOutcome outcome = sim.run(stage);
    EXPECT_EQ(outcome.status, dda::RunStatus::not_settled);
    EXPECT_EQ(sim.reports.size(), 20u);
    EXPECT_NE(outcome.message.find("after 20 steps block 0 at"), std::string::npos) << outcome.message;
    EXPECT_NE(outcome.message.find("in free fall"), std::string::npos) << outcome.message;
}

/// A block on a plane of 30 degrees with a friction angle of 20 degrees, which does not hold it.
struct Slide {
    Scene s;
    Slide() {
        s.friction(20);
        s.model.joint_materials[0].name = "bedding";
        const double angle = -M_PI / 6;
        const Vec2 along(std::cos(angle), std::sin(angle));
        s.box(-dda::perpendicular(along) - 10 * along, 30, 1, dda::Motion::fixed, angle);
        s.box({0, 0}, 2, 1, dda::Motion::free, angle);
    }
};

// Each static step starts from rest, so a block that slides moves by a dt^2 / 2 in it. The step grows until
// that is what a body falls from rest in the step of the control: here by the factor sqrt(g/a) = 1.64 for
// a = g (sin 30 - cos 30 tan 20). The way to the limit takes as many steps as it is long, whatever the time.
TEST(Run, TellsWhichBlockDoesNotStopAndAlongWhichJoint) {
    const Slide slide;
    Simulation sim(slide.s);
    dda::Stage stage;
    stage.name = "settle";
    stage.kind = dda::StageKind::static_equilibrium;
    stage.control.step = .02;
    stage.displacement_limit = .5;
    const dda::RunOutcome outcome = sim.run(stage);
    EXPECT_EQ(outcome.status, dda::RunStatus::not_settled);
    EXPECT_NE(outcome.message.find("stage 'settle' does not settle: block 1 at ("), std::string::npos)
        << outcome.message;
    EXPECT_NE(outcome.message.find("has moved 0.50"), std::string::npos) << outcome.message;
    EXPECT_NE(outcome.message.find("along 'bedding'"), std::string::npos) << outcome.message;
    const double g = 9.81;
    const double a = g * (std::sin(M_PI / 6) - std::cos(M_PI / 6) * std::tan(M_PI / 9));
    EXPECT_NEAR(sim.reports.back().step, .02 * std::sqrt(g / a), .02 * .02) << "2 %: strain and contacts";
    EXPECT_NEAR(static_cast<double>(sim.reports.size()), .5 / (g * .02 * .02 / 2), 15)
        << "the first steps are shorter";
}

/// A block of 2 m on a level floor that is thrown along it by 3 m/s.
Scene thrown_block() {
    Scene s;
    s.friction(35);
    s.box({0, -1}, 10, 1, dda::Motion::fixed);
    s.box({1, 0}, 2, 1);
    s.model.initial_velocity = {Vec6::Zero(), (Vec6() << 3, 0, 0, 0, 0, 0).finished()};
    return s;
}

// It slides by v^2 / 2 g mu from where it has settled, not in the static stage, and again only where a
// dynamic stage has not begun before.
TEST(Run, ABlockHasItsInitialVelocityWhereTheFirstDynamicStageBegins) {
    Simulation sim(thrown_block());
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.moved(1).x(), 0, 1e-6);
    ASSERT_EQ(sim.shake(1, .001).status, dda::RunStatus::completed);
    const double way = 9 / (2 * g * std::tan(radians(35)));
    EXPECT_NEAR(sim.moved(1).x(), way, 3 * .001) << "the velocity over a step";
    EXPECT_NEAR(sim.state.energy.residual(), 0, 1e-4 * sim.state.energy.losses());
    ASSERT_EQ(sim.shake(1, .001).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.moved(1).x(), way, 3 * .001) << "at rest";
}

// The block slides by v^2/2g mu = 0.66 m in the dynamic stage, and is at rest in the static one.
TEST(Run, WhatABlockMovedBeforeAStaticStageDoesNotCount) {
    Simulation sim(thrown_block());
    ASSERT_EQ(sim.shake(1, .002).status, dda::RunStatus::completed);
    ASSERT_GT(sim.moved(1).x(), .5);
    dda::Stage rest;
    rest.kind = dda::StageKind::static_equilibrium;
    rest.displacement_limit = .1;
    EXPECT_EQ(sim.run(rest).status, dda::RunStatus::completed);
}

// Near the equilibrium the displacements of a step vanish, and a static step may be fifty times the
// control's. The unbalanced force then falls by its square in each step instead of by a constant factor.
// A block at rest and a chip of 1e-6 of its mass that falls: the chip is gone when the next stage begins,
// with its energy, or it goes on falling.
TEST(Run, RemovesTheBlocksThatStillMoveAtTheEndOfAStaticStage) {
    Scene s;
    s.box({-1, -1}, 12, 1, dda::Motion::fixed);
    s.box({0, 0}, 10, 10);
    s.box({50, 0}, 0.01, 0.01);
    dda::Stage settle;
    settle.kind = dda::StageKind::static_equilibrium;
    dda::Stage wait;
    wait.duration = 0.1;
    std::vector<double> residuals;
    for (const bool removed : {false, true}) {
        settle.remove_moving = removed;
        const std::vector<dda::Stage> stages{settle, wait};
        dda::State state = dda::initial_state(s.model);
        dda::RunObserver observer;
        ASSERT_EQ(dda::run(s.model, stages, state, observer).status, dda::RunStatus::completed);
        EXPECT_EQ(state.is_present(2), !removed);
        EXPECT_TRUE(state.is_present(1));
        const double fallen = state.stage_origin[2].y() - state.blocks.centroid(2).y();
        EXPECT_NEAR(fallen, removed ? 0 : g * 0.1 * 0.1 / 2, removed ? 0 : 5e-3);
        residuals.push_back(state.energy.residual());
    }
    EXPECT_NEAR(residuals[1], residuals[0], 1e-9) << "the removed chip's energy is accounted for";
}

TEST(Run, AStaticStepGrowsWhereNothingMoves) {
    const Scene s = running_bond_wall(3, 6, 10);
    Simulation sim(s);
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    stage.control.step = .002;
    stage.tolerance = 1e-9;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    EXPECT_LT(sim.reports.size(), 60u) << "570 with a constant step";
    for (const dda::StepReport& report : sim.reports) {
        EXPECT_LE(report.step, 50 * .002 * (1 + 1e-12));
        EXPECT_LT(report.largest_displacement, 1.3 * 1.3 * 9.81 * .002 * .002 / 2 * (1 + 1e-9))
            << "the growth of one step at most";
    }
}

TEST(Run, EndsAtTheDurationOfTheStageForAnyStep) {
    for (const double step : {.03, .1, .0999999, .5}) {
        Scene s;
        s.box({0, 0}, 1, 100);
        Simulation sim(s);
        ASSERT_EQ(sim.shake(.1, step).status, dda::RunStatus::completed);
        EXPECT_NEAR(sim.state.stage_time, .1, 1e-12) << step;
        for (const auto& report : sim.reports) EXPECT_GT(report.step, .3 * std::min(step, .1)) << "no sliver";
    }
}

TEST(Run, LoadHistoriesCountTheTimeOfDynamicStages) {
    Scene s;
    s.model.gravity.setZero();
    s.box({0, 0}, 1, 1);
    s.model.loads.push_back(dda::BodyLoad{-1, {1, 0}, dda::TimeTable({0, .1, .2}, {0, 0, 1})});
    Simulation sim(s);
    ASSERT_EQ(sim.settle(.5, 1e-6).status, dda::RunStatus::completed);
    ASSERT_EQ(sim.shake(.1, .01).status, dda::RunStatus::completed);
    EXPECT_EQ(sim.velocity(0)[0], 0) << "the history is still zero";
    ASSERT_EQ(sim.shake(.1, .01).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.velocity(0)[0], .01 * (.1 + .2 + .3 + .4 + .5 + .6 + .7 + .8 + .9 + 1), 1e-12)
        << "m/s, dt times the sum of the ramp at the ends of steps";
}

TEST(Run, CompletesWithoutAFreeBlock) {
    Scene s;
    s.box({0, 0}, 1, 1, dda::Motion::fixed);
    Simulation sim(s);
    ASSERT_EQ(sim.shake(.1, .01).status, dda::RunStatus::completed);
    EXPECT_EQ(sim.moved(0), Vec2(0, 0));
}

// Every joint of the wall is about to slip, and the states of symmetric contacts alternate. Mixing the shear
// bounds from minimum to minimum makes the iteration converge.
TEST(Run, AWallUnderSuddenGravityNeedsNoCuts) {
    Simulation sim(running_bond_wall(20, 20, 10));
    ASSERT_EQ(sim.shake(.06, .005).status, dda::RunStatus::completed);
    EXPECT_EQ(sim.reports.size(), 12U);
    for (const auto& report : sim.reports) EXPECT_EQ(report.cuts, 0) << report.time;
}

struct Bytes {
    std::vector<Vec2> vertices;
    std::vector<Vec6> velocity;
    std::vector<double> forces;
    std::size_t candidates;
    bool operator==(const Bytes&) const = default;
};

/// A wall settled and then struck from the side.
Bytes shaken_wall(int columns, int rows, int threads) {
    const Scene s = running_bond_wall(columns, rows, 10);
    Simulation sim(s, threads);
    EXPECT_EQ(sim.settle(.005, 1e-3).status, dda::RunStatus::completed);
    for (int b = 1; b < s.model.block_count(); b += 3) sim.velocity(b)[0] = .5;
    EXPECT_EQ(sim.shake(.05, .0025).status, dda::RunStatus::completed);
    Bytes bytes{
        sim.state.blocks.vertices, sim.state.blocks.velocity, {}, sim.state.contacts.candidates.size()};
    for (const dda::Contact& c : sim.state.contacts.contacts)
        bytes.forces.insert(bytes.forces.end(), {c.normal_force, c.shear_force, c.slip});
    return bytes;
}

// 7 rows of 7 or 8 blocks. Loops of fewer than 512 indices run on one thread, so there must be more
// candidates.
TEST(Determinism, AWallIsBitwiseTheSameAgainAndOnTwoThreads) {
    const Bytes once = shaken_wall(7, 7, 1);
    EXPECT_EQ(shaken_wall(7, 7, 1), once);
    EXPECT_EQ(shaken_wall(7, 7, 2), once);
    EXPECT_GT(once.candidates, 512u);
}

/// Four blocks stacked out of line on a base. With initial velocities they slide, tilt and lose contact.
/// @param at offset of the model, m; @param order of the blocks
Simulation stack(const Vec2& at, const std::vector<int>& order) {
    Scene s;
    s.friction(20);
    s.box(at + Vec2(-4, -1), 12, 1, dda::Motion::fixed);
    const std::vector<Vec2> corners = {{0, 0}, {.25, 1}, {-.125, 2}, {1.5, 0}};
    for (const int k : order) s.box(at + corners[k], 1, 1);
    Simulation sim(s);
    EXPECT_EQ(sim.settle(.005, 1e-4).status, dda::RunStatus::completed);
    for (std::size_t b = 1; b <= order.size(); ++b)
        sim.velocity(static_cast<int>(b))[0] = .3 * (1 + order[b - 1]);
    EXPECT_EQ(sim.shake(.3, 1e-3).status, dda::RunStatus::completed);
    return sim;
}

// An offset of a power of two does not round the coordinates, whose resolution becomes 2^-33 m. Times the
// penalty this is a noise of 6 N in each contact force, 1/4000 of a block's weight. Displacements may change
// by four times this ratio.
TEST(Invariance, OfAModelMovedByAMillionMetres) {
    const Simulation here = stack({0, 0}, {0, 1, 2, 3});
    const Simulation far = stack({1048576, -1048576}, {0, 1, 2, 3});
    for (int b = 1; b <= 4; ++b) {
        EXPECT_GT(here.moved(b).norm(), .02);
        EXPECT_LT((far.moved(b) - here.moved(b)).norm(), 1e-3 * here.moved(b).norm()) << "block " << b;
    }
}

TEST(Invariance, OfTheOrderOfBlocks) {
    const Simulation first = stack({0, 0}, {0, 1, 2, 3});
    const std::vector<int> order = {3, 1, 0, 2};
    const Simulation second = stack({0, 0}, order);
    for (std::size_t k = 0; k < order.size(); ++k) {
        EXPECT_LT((second.moved(static_cast<int>(k) + 1) - first.moved(order[k] + 1)).norm(), 1e-7)
            << "block " << order[k];
    }
}

}  // namespace
}  // namespace rockslope::run_test
