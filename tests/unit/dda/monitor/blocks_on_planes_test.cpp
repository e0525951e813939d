#include "dda/monitor/blocks_on_planes.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "dda/monitor/first_slips.hpp"
#include "support/scene.hpp"

namespace rockslope::dda {
namespace {

using scene::radians;
using scene::Scene;
using scene::Simulation;

/// A block of 2 m x 1 m on a prescribed base that dips to the right, another block on top of it, and one far
/// off in free fall. Angles in degrees.
struct Tower {
    Scene s;
    explicit Tower(double dip, double friction, double cohesion = 0) {
        const double angle = -radians(dip);
        const Vec2 along(std::cos(angle), std::sin(angle));
        s.model.joint_materials[0].law = Scene::mohr_coulomb(friction, cohesion);
        s.box(-perpendicular(along) - 10 * along, 30, 1, Motion::prescribed, angle, "base");
        s.box({0, 0}, 2, 1, Motion::free, angle);
        s.box(perpendicular(along), 2, 1, Motion::free, angle);
        s.box({200, 0}, 1, 1);
    }
};

TimeTable sampled(double duration, const std::function<double(double)>& f) {
    std::vector<double> times, values;
    for (int k = 0; k * 5e-4 <= duration + 1e-9; ++k) {
        times.push_back(k * 5e-4);
        values.push_back(f(k * 5e-4));
    }
    return {times, values};
}

TEST(BlocksOnPlanes, FindsTheBlocksOnOnePlaneOfAPrescribedBlock) {
    const Tower tower(20, 35);
    Simulation sim(tower.s);
    ASSERT_EQ(sim.shake(0.05, 1e-3).status, RunStatus::completed);
    // The lower block is loaded from above by the upper one: it does not rest on a single plane.
    EXPECT_TRUE(find_blocks_on_planes(sim.model, sim.state).empty());

    Tower single(20, 35);
    single.s.model.motion[2] = Motion::removed;
    Simulation alone(single.s);
    ASSERT_EQ(alone.shake(0.05, 1e-3).status, RunStatus::completed);
    const std::vector<BlockOnPlane> planes = find_blocks_on_planes(alone.model, alone.state);
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_EQ(planes[0].block, 1);
    EXPECT_EQ(planes[0].base, 0);
    EXPECT_NEAR(planes[0].dip, radians(20), 1e-6);
    EXPECT_NEAR(planes[0].downhill.x(), std::cos(radians(20)), 1e-6);
    EXPECT_LT(planes[0].downhill.y(), 0);
    EXPECT_NEAR(planes[0].peak.friction, std::tan(radians(35)), 1e-12);
    EXPECT_NEAR(yield_coefficient(planes[0], scene::g), std::tan(radians(15)), 1e-6);
}

TEST(BlocksOnPlanes, CohesionAndStrengthReductionEnterTheYieldCoefficient) {
    Tower tower(20, 35, 5e3);
    tower.s.model.motion[2] = Motion::removed;
    tower.s.model.topology.joint_material.assign(tower.s.model.topology.joint_material.size(), 0);
    tower.s.model.strength_reduction = 1.25;
    Simulation sim(tower.s);
    ASSERT_EQ(sim.shake(0.02, 1e-3).status, RunStatus::completed);
    const std::vector<BlockOnPlane> planes = find_blocks_on_planes(sim.model, sim.state);
    ASSERT_EQ(planes.size(), 1u);
    const double mass = 2 * 2500;
    EXPECT_NEAR(planes[0].peak.adhesion, 5e3 * 2 / mass / 1.25, 1e-3);
    EXPECT_NEAR(planes[0].peak.friction, std::tan(radians(35)) / 1.25, 1e-12);
    EXPECT_EQ(planes[0].residual.adhesion, 0);
    const double mu = planes[0].peak.friction, k = yield_coefficient(planes[0], scene::g);
    const double s = std::sin(radians(20)), c = std::cos(radians(20));
    EXPECT_NEAR(scene::g * s + k * scene::g * c,
                mu * (scene::g * c - k * scene::g * s) + planes[0].peak.adhesion, 1e-6)
        << "driving force equals resistance at yield";
}

// V14: dip 20, friction 30, 0.3 g sin 2 pi t; slip after each second as integrated there. A motion of the
// base and a body load of the opposite sign are equivalent.
TEST(BlocksOnPlanes, TheEstimateIsNewmarksForBaseMotionsAndBodyLoads) {
    Model model;
    model.motion = {Motion::prescribed, Motion::free};
    model.block_name = {"base", ""};
    const double mu = std::tan(radians(30));
    const BlockOnPlane plane{1,           0,       {std::cos(radians(20)), -std::sin(radians(20))},
                             radians(20), {mu, 0}, {mu, 0}};
    const auto shaking = [](double t) { return 0.3 * scene::g * std::sin(2 * std::numbers::pi * t); };
    Stage quiet, stage;
    quiet.duration = 1;
    stage.duration = 5;
    const double expected[] = {.06483, .13604, .20726, .27847, .34968};
    stage.base_motions.push_back({"base", sampled(5, shaking), TimeTable({0}, {0})});
    Model loaded = model;
    loaded.loads.push_back(
        BodyLoad{1, {-1, 0}, sampled(6, [&](double t) { return t < 1 ? 0 : shaking(t - 1); })});
    Stage still = stage;
    still.base_motions.clear();
    for (int k = 0; k < 5; ++k) {
        const double time = 1 + k + 1;
        EXPECT_NEAR(rigid_slip(model, std::vector{quiet, stage}, plane, time), expected[k], 2e-5);
        EXPECT_NEAR(rigid_slip(loaded, std::vector{quiet, still}, plane, time), expected[k], 2e-5);
    }
}

// A level base with friction for 0.2 g accelerates by 5 t m/s2: slip begins at 1.962 / 5 = 0.3924 s. The
// run's slip is later by the elastic shear of the springs and by less than a step.
TEST(FirstSlips, BeginWhenTheBaseExceedsTheFriction) {
    Tower tower(0, std::atan(0.2) * 180 / std::numbers::pi);
    tower.s.model.motion[2] = Motion::removed;
    tower.s.model.motion[3] = Motion::fixed;
    Simulation sim(tower.s);
    PerBlock<FirstSlip> slips(4);
    ASSERT_EQ(sim.settle().status, RunStatus::completed);
    sim.on_step = [&](const State& state, const StepReport& report) {
        update_first_slips(sim.model, state, report, 1e-4, slips);
    };
    Stage stage;
    stage.duration = 0.6;
    stage.control.step = 1e-3;
    stage.base_motions.push_back({"base", TimeTable({0, 1}, {0, 5}), TimeTable({0}, {0})});
    const double start = sim.state.time;
    ASSERT_EQ(sim.run(stage).status, RunStatus::completed);
    EXPECT_TRUE(slips[1].has_slipped());
    EXPECT_NEAR(slips[1].dynamic_time, 0.3924, 2e-3);
    EXPECT_NEAR(slips[1].time, start + slips[1].dynamic_time, 1e-9);
    EXPECT_EQ(slips[1].other, 0);
    EXPECT_EQ(slips[1].joint_material, 0);
    EXPECT_FALSE(slips[0].has_slipped()) << "a prescribed block does not slip";
    EXPECT_FALSE(slips[3].has_slipped()) << "a fixed block does not slip";
}

}  // namespace
}  // namespace rockslope::dda
