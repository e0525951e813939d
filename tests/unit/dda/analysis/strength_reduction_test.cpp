#include "dda/analysis/strength_reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/joint/barton_bandis.hpp"
#include "support/scene.hpp"

namespace rockslope::strength_reduction_test {
namespace {

using namespace scene;

struct Searched : Simulation {
    using Simulation::Simulation;
    bool trial_step_done(const dda::Model&, const dda::State&, const dda::Stage&,
                         const dda::StepReport&) override {
        return --steps_allowed > 0;
    }
    void trial_done(const dda::Model&, const dda::State&, const dda::Stage&,
                    const dda::ReductionTrial& trial) override {
        trials.push_back(trial);
        (trial.stands ? stands : fails) =
            trial.stands ? std::max(stands, trial.factor) : std::min(fails, trial.factor);
    }
    void mechanism_found(const dda::Model&, const dda::State& failed, const dda::Stage&) override {
        mechanism_move = (failed.blocks.centroid(1) - state.blocks.centroid(1)).norm();
    }
    dda::RunOutcome search(double width, int step_limit = 400, double lowest = .1, double highest = 10) {
        dda::Stage stage;
        stage.name = "search";
        stage.kind = dda::StageKind::static_equilibrium;
        stage.tolerance = 1e-5;
        stage.step_limit = step_limit;
        stage.reset_displacements = false;
        stage.strength_reduction = {lowest, highest, width, .05};
        return run(stage);
    }
    std::vector<dda::ReductionTrial> trials;
    double stands = 0;
    double fails = 1e9;
    double mechanism_move = 0;
    int steps_allowed = 1000000;
};

/// A block of 2 m x 1 m on a plane of the given angle, in degrees.
Scene on_incline(double angle, double friction, double cohesion) {
    Scene s;
    dda::MohrCoulomb law = Scene::mohr_coulomb(friction, cohesion);
    law.residual_cohesion = cohesion;
    s.model.joint_materials[0].law = law;
    const double a = radians(angle);
    const Vec2 along(std::cos(a), std::sin(a));
    s.box({0, 0}, 6, 1, dda::Motion::fixed, a);
    s.box(2 * along + dda::perpendicular(along), 2, 1, dda::Motion::free, a);
    return s;
}

TEST(StrengthReduction, FindsTheFactorOfABlockOnAPlane) {
    Searched sim(on_incline(20, 30, 0));
    sim.settle(.005, 1e-6);
    const std::vector<Vec2> before = sim.state.blocks.vertices;
    const double clock = sim.state.time;
    ASSERT_EQ(sim.search(.002).status, dda::RunStatus::completed);
    const double exact = std::tan(radians(30)) / std::tan(radians(20));
    EXPECT_LE(sim.fails / sim.stands, 1.002);
    EXPECT_LE(sim.stands, exact * (1 + 1e-4)) << "friction is at its limit within the force tolerance";
    EXPECT_GE(sim.fails, exact * (1 - 1e-4));
    EXPECT_EQ(sim.state.blocks.vertices, before) << "the search must not move the blocks";
    EXPECT_GT(sim.state.time, clock);
    const auto failed_trial = std::find_if(sim.trials.begin(), sim.trials.end(),
                                           [&](const auto& trial) { return trial.factor == sim.fails; });
    EXPECT_EQ(sim.mechanism_move, failed_trial->displacement)
        << "reported last: the smallest factor that fails";
    EXPECT_GT(sim.mechanism_move, 0);
}

// The strength of a joint that wears is at most that of its fresh surface, at least that of the worn one. Its
// force may lag behind a strength that wears down, but not behind one that is reduced: while it did, slopes
// of such joints stood under factors of up to 7.9 here.
TEST(StrengthReduction, LeavesNoJointMoreThanItsReducedStrength) {
    const double load = std::tan(radians(16));
    for (const double stiffness : {1e6, 1e7, 1e8}) {
        for (const double roughness_length : {2e-4, 1e-3, 5e-3}) {
            SCOPED_TRACE(testing::Message() << stiffness << " N/m, " << roughness_length << " m");
            Scene s = on_incline(16, 30, 0);
            s.model.joint_materials[0].law =
                dda::ContinuouslyYielding{radians(32), radians(24), roughness_length};
            s.model.joint_materials[0].shear_penalty = stiffness;
            Searched sim(s);
            ASSERT_EQ(sim.settle(.005, 1e-6).status, dda::RunStatus::completed);
            ASSERT_EQ(sim.search(.01).status, dda::RunStatus::completed);
            EXPECT_LE(sim.stands, std::tan(radians(32)) / load * (1 + 1e-4));
            EXPECT_GE(sim.fails, std::tan(radians(24)) / load * (1 - 1e-4));
        }
    }
}

// A block slips until enough roughness is mobilised. It stands while the peak strength suffices: Eq. (57) at
// the mean stress of the plane.
TEST(StrengthReduction, ReducesRoughnessLikeFriction) {
    const double angle = 50;
    Scene s = on_incline(angle, 0, 0);
    const dda::BartonStrength barton{8, 50e6, radians(28)};
    s.model.joint_materials[0].law = dda::BartonBandis{barton, 2e-3, dda::barton_1985(), true, 1};
    // The toe carries four fifths of the weight. With the soft spring of Eq. (58) the shear force at the toe
    // would develop only after the joint has passed its peak, at a factor 3 % lower.
    s.model.joint_materials[0].shear_penalty = 1e10;
    Searched sim(s);
    ASSERT_EQ(sim.settle(.005, 1e-6).status, dda::RunStatus::completed);
    // The block moves by about 1e-5 m in a step, and by less as it comes to rest.
    ASSERT_EQ(sim.search(.002, 4000).status, dda::RunStatus::completed);
    const double weight = 2 * s.model.block_materials[0].density * s.model.gravity.norm();
    const double exact =
        barton.shear_strength(weight * std::cos(radians(angle)), 2, 1) / (weight * std::sin(radians(angle)));
    EXPECT_LE(sim.fails / sim.stands, 1.002);
    EXPECT_LE(sim.stands, exact * (1 + 1e-4)) << "friction is at its limit within the force tolerance";
    // The last steps may carry the block past the peak, where less roughness is mobilised.
    EXPECT_GE(sim.fails, exact * (1 - 1e-3));
}

TEST(StrengthReduction, ReducesCohesionLikeFriction) {
    const double cohesion = 4000;
    Searched sim(
        on_incline(35, 20, cohesion));  // it does not stand: a settling stage would let it slide away
    ASSERT_EQ(sim.search(.005).status, dda::RunStatus::completed);
    const double a = radians(35);
    const double weight = 2 * 2500 * 9.81;
    const double exact =
        (weight * std::cos(a) * std::tan(radians(20)) + cohesion * 2) / (weight * std::sin(a));
    EXPECT_LE(sim.stands, exact * (1 + 1e-3));
    EXPECT_GE(sim.fails, exact * (1 - 1e-3));
}

TEST(StrengthReduction, IsBelowOneForAnUnstableBlock) {
    Searched sim(on_incline(30, 20, 0));
    ASSERT_EQ(sim.search(.02).status, dda::RunStatus::completed);
    const double exact = std::tan(radians(20)) / std::tan(radians(30));
    EXPECT_LE(sim.stands, exact * (1 + 1e-4));
    EXPECT_GE(sim.fails, exact * (1 - 1e-4));
    EXPECT_LE(sim.fails / sim.stands, 1.02);
}

TEST(StrengthReduction, EndsAtItsLimitsWhereNothingFails) {
    Scene s;
    s.friction(30);
    s.box({0, 0}, 4, 1, dda::Motion::fixed);
    s.box({1, 1}, 1, 1);
    Searched sim(s);
    ASSERT_EQ(sim.search(.01).status, dda::RunStatus::completed);
    EXPECT_EQ(sim.stands, 10);
    EXPECT_EQ(sim.fails, 1e9);
    EXPECT_EQ(sim.trials.size(), 5U);
}

// The factors of the two blocks are 1.59 and 0.63. A limit on the near side is tried, and is the bound that
// is known; one on the far side ends the bracket.
TEST(StrengthReduction, TriesItsLimits) {
    Searched sim(on_incline(20, 30, 0));
    sim.settle(.005, 1e-6);
    ASSERT_EQ(sim.search(.02, 400, .1, 1.5).status, dda::RunStatus::completed);
    EXPECT_EQ(sim.stands, 1.5);
    EXPECT_EQ(sim.fails, 1e9);
    ASSERT_EQ(sim.search(.02, 400, .1, 1.7).status, dda::RunStatus::completed);
    EXPECT_LE(sim.fails / sim.stands, 1.02);

    Searched unstable(on_incline(30, 20, 0));
    ASSERT_EQ(unstable.search(.02, 400, .8).status, dda::RunStatus::completed);
    EXPECT_EQ(unstable.stands, 0);
    EXPECT_EQ(unstable.fails, .8);
}

TEST(StrengthReduction, StopsIfTheObserverSaysSo) {
    Searched sim(on_incline(20, 30, 0));
    sim.steps_allowed = 3;
    EXPECT_EQ(sim.search(.01).status, dda::RunStatus::stopped);
    EXPECT_TRUE(sim.trials.empty());
}

}  // namespace
}  // namespace rockslope::strength_reduction_test
