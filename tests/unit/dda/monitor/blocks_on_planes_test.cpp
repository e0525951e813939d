#include "dda/monitor/blocks_on_planes.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "dda/monitor/first_slips.hpp"
#include "support/scene.hpp"

namespace rockslope::dda::blocks_on_planes_test {
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

/// The plane of the lower block of a tower, without cohesion.
BlockOnPlane plane_of(double dip, double friction) {
    const double angle = radians(dip), mu = std::tan(radians(friction));
    return {1, 0, {std::cos(angle), -std::sin(angle)}, angle, {mu, 0}, {mu, 0}};
}

TimeTable sampled(double duration, const std::function<double(double)>& f) {
    std::vector<double> times, values;
    for (int k = 0; k * 5e-4 <= duration + 1e-9; ++k) {
        times.push_back(k * 5e-4);
        values.push_back(f(k * 5e-4));
    }
    return {times, values};
}

// Its yield coefficient would be infinite, or no number.
TEST(BlocksOnPlanes, LeavesOutABlockThatIsGluedToItsBase) {
    Tower glued(20, 35);
    glued.s.model.joint_materials[0].law = Elastic{};
    glued.s.model.motion[2] = Motion::removed;
    Simulation sim(glued.s);
    ASSERT_EQ(sim.shake(0.05, 1e-3).status, RunStatus::completed);
    EXPECT_TRUE(find_blocks_on_planes(sim.model, sim.state).empty());
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
    EXPECT_NEAR(yield_coefficient(alone.model, planes[0]), std::tan(radians(15)), 1e-6);
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
    const double mu = planes[0].peak.friction, k = yield_coefficient(sim.model, planes[0]);
    const double s = std::sin(radians(20)), c = std::cos(radians(20));
    EXPECT_NEAR(scene::g * s + k * scene::g * c,
                mu * (scene::g * c - k * scene::g * s) + planes[0].peak.adhesion, 1e-6)
        << "driving force equals resistance at yield";
}

// V14: dip 20, friction 30, 0.3 g sin 2 pi t; slip after each second as integrated there. A motion of the
// base and a body load of the opposite sign are equivalent.
TEST(BlocksOnPlanes, TheEstimateIsNewmarksForBaseMotionsAndBodyLoads) {
    const Model model = Tower(20, 30).s.model;
    const BlockOnPlane plane = plane_of(20, 30);
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

// A block of 5 t and 2 m on a plane that dips at 40 degrees, with a friction angle of 35 degrees, slides from
// the start by a t^2 / 2, a = (g sin + a_t) - mu (g cos + a_n), with the accelerations a_t downhill and a_n
// into the plane by the load.
class LoadedSlider : public testing::Test {
  protected:
    static constexpr double dip = 40, friction = 35, mass = 2 * 2500, length = 2;
    Scene s = Tower(dip, friction).s;
    const BlockOnPlane plane = plane_of(dip, friction);
    const double sine = std::sin(radians(dip)), cosine = std::cos(radians(dip));
    const double mu = std::tan(radians(friction));
    const Vec2 downhill = plane.downhill, inward = {-sine, -cosine};
    const TimeTable always{{0}, {1}};

    static EdgeIndex bottom() { return 4; }  ///< the edges of the block follow those of the base
    static EdgeIndex top() { return 6; }
    static std::vector<EdgeIndex> perimeter() { return {4, 5, 6, 7}; }

    double expected(double downhill_load, double normal_load, double time = 1) const {
        return (scene::g * sine + downhill_load - mu * (scene::g * cosine + normal_load)) * time * time / 2;
    }
    double estimate(double time = 1) const {
        Stage stage;
        stage.duration = 2;
        return rigid_slip(s.model, std::vector{stage}, plane, time);
    }
};

TEST_F(LoadedSlider, SlidesUnderItsWeightAlone) {
    EXPECT_NEAR(estimate(), expected(0, 0), 1e-9);
}

TEST_F(LoadedSlider, FeelsForcesAtItsPointsOnly) {
    const Vec2 force = 3000 * downhill + 2000 * inward;
    s.model.loads.push_back(PointLoad{s.material_point(1, s.model.vertices[6]), force, always});
    s.model.loads.push_back(PointLoad{s.material_point(2, s.model.vertices[8]), 5 * force, always});
    EXPECT_NEAR(estimate(), expected(3000 / mass, 2000 / mass), 1e-9);
}

TEST_F(LoadedSlider, FeelsPressureAndTractionOnItsFaces) {
    LoadedFace face{{top(), 0, 1}, 500, 1500, 100 * downhill, 300 * downhill};
    s.model.loads.push_back(LineLoad{{face}, always});
    EXPECT_NEAR(estimate(), expected(200 * length / mass, 1000 * length / mass), 1e-9);
}

// The water carries a part of the weight: friction acts on the effective normal force.
TEST_F(LoadedSlider, IsLiftedByWaterInItsPlane) {
    constexpr EdgeIndex base_top = 2;
    s.model.loads.push_back(JointWater{{bottom(), base_top}, 5000, always});
    EXPECT_NEAR(estimate(), expected(0, -5000 * length / mass), 1e-9);
}

// Archimedes: the water takes the weight of its volume, 2 m3 for each metre.
TEST_F(LoadedSlider, IsBuoyantInStillWater) {
    s.model.loads.push_back(HeadWater{perimeter(), {{-50, 20}, {50, 20}}, 9810, always});
    const double lift = 9810 * 2 / mass;
    EXPECT_NEAR(estimate(), (1 - lift / scene::g) * expected(0, 0), 1e-9);
}

// The load acts from 0.5 s of dynamic time on: s(1) = a0 / 2 + a1 0.5^2 / 2.
TEST_F(LoadedSlider, FollowsTheHistoryOfALoad) {
    const TimeTable late({0, 0.5, 0.5 + 1e-9, 2}, {0, 0, 1, 1});
    s.model.loads.push_back(PointLoad{s.material_point(1, {0, 0}), 3000 * downhill, late});
    EXPECT_NEAR(estimate(), expected(0, 0) + 3000 / mass * 0.25 / 2, 1e-6);
}

TEST_F(LoadedSlider, YieldsWhereDriveWithLoadsEqualsResistance) {
    s.model.loads.push_back(JointWater{{bottom()}, 2000, always});
    s.model.loads.push_back(PointLoad{s.material_point(1, {0, 0}), -9000 * downhill, always});
    const double k = yield_coefficient(s.model, plane);
    EXPECT_GT(k, 0) << "the force holds the block";
    EXPECT_NEAR(scene::g * sine - 9000 / mass + k * scene::g * cosine,
                mu * (scene::g * cosine - 2000 * length / mass - k * scene::g * sine), 1e-9);
}

// The run of deformable blocks is the estimate's peer: at rest on stiff springs, then under water.
TEST_F(LoadedSlider, SlidesLikeTheSimulatedBlock) {
    s.model.motion[2] = s.model.motion[3] = Motion::removed;
    s.model.loads.push_back(JointWater{{bottom()}, 5000, always});
    Simulation sim(s);
    ASSERT_EQ(sim.shake(0.5, 1e-3).status, RunStatus::completed);
    EXPECT_NEAR(simulated_slip(sim.state, plane), estimate(0.5), 0.01 * estimate(0.5));
}

TEST_F(LoadedSlider, SaysWhatItIgnores) {
    EXPECT_TRUE(ignored_by_estimate(s.model, plane).empty());
    const int here = s.material_point(1, {0, 0}), there = s.material_point(2, {0, 1});
    s.model.bolts.push_back({"other", there, there, 1e6, 0, 0});
    s.model.fixed_points.push_back({there, true, true});
    s.model.viscous_boundaries.push_back({"base", {{EdgeIndex(0), 0, 1}}});
    s.model.initial_velocity.assign(4, Vec6::Zero());
    EXPECT_TRUE(ignored_by_estimate(s.model, plane).empty()) << "they act on other blocks";
    s.model.bolts.push_back({"anchor", there, here, 1e6, 0, 0});
    s.model.fixed_points.push_back({here, true, false});
    s.model.viscous_boundaries.push_back({"side", {{bottom(), 0, 1}}});
    s.model.initial_velocity[plane.block][0] = 1;
    EXPECT_EQ(
        ignored_by_estimate(s.model, plane),
        (std::vector<std::string>{"bolts", "fixed points", "viscous boundaries", "initial velocities"}));
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
}  // namespace rockslope::dda::blocks_on_planes_test
