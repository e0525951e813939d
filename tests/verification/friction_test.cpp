// A block on a plane: sliding, sticking, braking, standing still.

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace {

using namespace scene;

/// A fixed incline and a block upon it; the block is settled as if glued, and the friction angle is set for
/// the motion.
struct Incline {
    explicit Incline(double psi_degrees, double width = 1, double height = 1) : psi(radians(psi_degrees)) {
        const Vec2 along(std::cos(psi), std::sin(psi));
        s.box(-dda::perpendicular(along), 60, 1, dda::Motion::fixed, psi);
        block = s.box(30 * along, width, height, dda::Motion::free, psi);
    }
    /// Distance slid downhill, m, in `time` after a settled start.
    double slide(double phi_degrees, double time, double step) {
        s.friction(80);
        const Simulation glued = [&] {
            Simulation sim(s);
            EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
            return sim;
        }();
        s.friction(phi_degrees);
        Simulation sim(s);
        sim.state = glued.state;
        EXPECT_EQ(sim.shake(time, step).status, dda::RunStatus::completed);
        residual = std::abs(sim.state.energy.residual());
        exchanged = sim.state.energy.kinetic + sim.state.energy.friction_loss;
        return -sim.moved(block).dot(Vec2(std::cos(psi), std::sin(psi)));
    }
    double psi;
    Scene s;
    int block = 0;
    double residual = 0;
    double exchanged = 0;
};

struct SlideCase {
    double psi, phi, distance;
};
class Sliding : public testing::TestWithParam<SlideCase> {};

// V08. s = (sin psi - cos psi tan phi) g t^2 / 2. From settled contact the only error is the elastic
// take-off, of the order of a penetration.
TEST_P(Sliding, FollowsTheClosedForm) {
    const auto [psi, phi, distance] = GetParam();
    Incline incline(psi, 2, 1);
    EXPECT_NEAR(incline.slide(phi, 1, 1e-3), distance, 1e-3 * distance);
    // What the ledger leaves unexplained after a thousand steps is rounding and linear kinematics.
    EXPECT_LT(incline.residual, 1e-6 * incline.exchanged);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Sliding,
                         testing::Values(SlideCase{22.6, 5, 1.48879}, SlideCase{22.6, 10, 1.08650},
                                         SlideCase{22.6, 15, .67160}, SlideCase{22.6, 20, .23679},
                                         SlideCase{30, 0, 2.45250}, SlideCase{30, 10, 1.70349},
                                         SlideCase{30, 20, .90641}, SlideCase{45, 30, 1.46590}));

// V09. A tenth of a degree on either side of the limit.
TEST(StickThreshold, HoldsAboveAndSlidesBelow) {
    EXPECT_LT(std::abs(Incline(30).slide(30.1, 5, 5e-3)), 1e-5);
    const double a = g * (std::sin(radians(30)) - std::cos(radians(30)) * std::tan(radians(29.9)));
    EXPECT_NEAR(a, .0198, 5e-5);
    EXPECT_NEAR(Incline(30).slide(29.9, 5, 5e-3) / 12.5, a, 0.03 * a);
}

// V10, V11. v0 = 2 m/s on the flat at 25 degrees: stops after v0^2/(2 mu g) in v0/(mu g); friction takes all
// of m v0^2/2.
TEST(Braking, StopsWhereAndWhenItMustAndFrictionTakesTheEnergy) {
    Scene s;
    s.friction(25);
    s.box({-1, -1}, 6, 1, dda::Motion::fixed);
    const int block = s.box({0, 0}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    sim.velocity(block)[0] = 2;
    const double moving = 2500.0 * 2 * 2 / 2;
    sim.restart_ledger();
    double stopped = 0;
    sim.each_step = [&](const dda::State& state, const dda::StepReport&) {
        if (stopped == 0 && state.blocks.velocity[1][0] <= 1e-3) stopped = state.stage_time;
    };
    ASSERT_EQ(sim.shake(1, 5e-4).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.moved(block).x(), .43721, .005 * .43721);
    EXPECT_NEAR(stopped, .43721, .005 * .43721);
    EXPECT_NEAR(sim.state.energy.friction_loss, moving, 0.01 * moving);
    EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-3 * moving);
}

struct RestCase {
    double penalty_over_e, step;
};
class StandStill : public testing::TestWithParam<RestCase> {
  protected:
    static Incline incline() {
        Incline made(30);
        made.s.friction(35);
        made.s.model.normal_penalty = made.s.model.shear_penalty = GetParam().penalty_over_e * 10e9;
        return made;
    }
};

// A block that must stand still stands still: 30 degrees, phi = 35. Settled, it creeps less than 1e-6 m in
// ten seconds; set down unsettled, it comes to rest within 1e-4 m. Both bounds are requirements, not
// measurements: seen are 1e-13 and 6e-5.
TEST_P(StandStill, OnceSettled) {
    const Incline made = incline();
    Simulation sim(made.s);
    ASSERT_EQ(sim.settle(GetParam().step, 1e-6).status, dda::RunStatus::completed);
    ASSERT_EQ(sim.shake(10, GetParam().step).status, dda::RunStatus::completed);
    EXPECT_LT(sim.moved(made.block).norm(), 1e-6);
}

TEST_P(StandStill, SetDownUnsettled) {
    const Incline made = incline();
    Simulation sim(made.s);
    ASSERT_EQ(sim.shake(10, GetParam().step).status, dda::RunStatus::completed);
    EXPECT_LT(sim.moved(made.block).norm(), 1e-4);
    EXPECT_LT(sim.velocity(made.block).head<2>().norm(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Contract, StandStill,
                         testing::Values(RestCase{1, 1e-4}, RestCase{1, 1e-3}, RestCase{1, 1e-2},
                                         RestCase{10, 1e-4}, RestCase{10, 1e-3}, RestCase{10, 1e-2},
                                         RestCase{100, 1e-4}, RestCase{100, 1e-3}, RestCase{100, 1e-2}));

// V35. Direct shear under 1 MPa, c = 0.1 MPa, phi = 30: c + tan phi at the peak, tan phi after it. The lower
// half moves steadily, the upper is held along the joint; an increment is 1e3 N of 6.8e5, so the peak is met
// within 0.2 %.
TEST(DirectShear, ReachesPeakAndResidualStrength) {
    Scene s;
    s.model.gravity.setZero();
    s.model.joint_materials[0].law = Scene::mohr_coulomb(30, 0.1e6);
    s.model.block_materials[0].poissons_ratio =
        0;  // no shear from lateral expansion, so both ends slip at once
    const int lower = s.box({-1, -1}, 3, 1, dda::Motion::prescribed, 0, "lower");
    const int upper = s.box({0, 0}, 1, 1);
    for (const double x : {0.0, 1.0}) {
        s.model.fixed_points.push_back({s.material_point(upper, {x, 0}), true, false});
        s.model.loads.push_back(dda::PointLoad{s.material_point(upper, {x, 1}), {0, -0.5e6}, {}});
    }
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    sim.velocity(lower)[0] = 1e-5;
    double peak = 0;
    double last = 0;
    sim.each_step = [&](const dda::State& state, const dda::StepReport&) {
        last = 0;
        for (const dda::Contact& contact : state.contacts.contacts) last += std::abs(contact.shear_force);
        peak = std::max(peak, last);
    };
    dda::Stage stage;
    stage.name = "shear";
    stage.duration = 1.0;
    stage.dynamic_coefficient = 0;
    stage.control.step = 1e-3;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    EXPECT_NEAR(peak, .6774e6, .005 * .6774e6);
    EXPECT_NEAR(last, .5774e6, .005 * .5774e6);
}

}  // namespace
