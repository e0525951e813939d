// Blocks held by bolts, fixed points or bonds alone.

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::constraints_test {
namespace {

using namespace scene;

constexpr double weight = 2500 * g;
constexpr double axial_stiffness = 2e7;

/// A unit block hung from a fixed block by one bolt of 2 m.
struct Hung {
    Scene s;
    int block;
    explicit Hung(double yield_force = 0, double pretension = 0) {
        const int roof = s.box({0, 3}, 1, 1, dda::Motion::fixed);
        block = s.box({0, 0}, 1, 1);
        const int top = s.material_point(roof, {.5, 3});
        const int bottom = s.material_point(block, {.5, 1});
        s.model.bolts.push_back({"bolt", top, bottom, axial_stiffness, pretension, yield_force});
    }
};

// The centroid is below the end of the bolt, so equilibrium is stable, and the bolt carries the whole weight.
TEST(Bolt, CarriesTheWeightOfAHungBlock) {
    Hung h;
    Simulation sim(h.s);
    ASSERT_EQ(sim.settle(.005, 1e-9).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.state.bolt_force[0], weight, 1e-6 * weight);
    const double elongation = sim.state.blocks.points[0].y() - sim.state.blocks.points[1].y() - 2;
    EXPECT_NEAR(elongation, weight * 2 / axial_stiffness, 1e-6 * elongation);
}

TEST(Bolt, DoesNotStretchIfPretensionEqualsTheWeight) {
    Hung h(0, weight);
    Simulation sim(h.s);
    ASSERT_EQ(sim.settle(.005, 1e-9).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.state.bolt_force[0], weight, 1e-6 * weight);
    // Only the block strains between its centroid and the end of the bolt, by about W/(2 E).
    EXPECT_LT(sim.moved(h.block).norm(), 2 * weight / 10e9);
}

// A bolt that yields at half the weight lets the block fall with g / 2. With pretension at the yield force it
// yields from the first step on.
TEST(Bolt, YieldsAtItsYieldForce) {
    Hung h(weight / 2, weight / 2);
    Simulation sim(h.s);
    ASSERT_EQ(sim.shake(.1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.state.bolt_force[0], weight / 2, 1e-9 * weight);
    EXPECT_NEAR(sim.moved(h.block).y(), -g / 2 * .01 / 2, 1e-3 * g / 2 * .01 / 2);
    EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-6 * weight);
}

// The rounding of the tension over the very small stiffness of this bolt must not count as plastic
// elongation.
TEST(Bolt, DissipatesNothingBelowItsYieldForce) {
    Hung h(0, 1e4);
    h.s.model.bolts[0].axial_stiffness = 1e-3;
    Simulation sim(h.s);
    ASSERT_EQ(sim.shake(.1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_LT(sim.moved(h.block).y(), -.01);
    EXPECT_EQ(sim.state.energy.friction_loss, 0);
}

TEST(FixedPoints, MoveByTheForceOverTheirStiffness) {
    Scene s;
    const int block = s.box({0, 0}, 1, 1);
    for (const double x : {0.0, 1.0}) s.model.fixed_points.push_back({s.material_point(block, {x, 1})});
    Simulation sim(s);
    ASSERT_EQ(sim.settle(.005, 1e-9).status, dda::RunStatus::completed);
    const double sag = weight / 2 / s.model.fixed_point_penalty;
    for (const Vec2& point : {sim.state.blocks.points[0], sim.state.blocks.points[1]}) {
        EXPECT_NEAR(point.y(), 1 - sag, 1e-3 * sag);
    }
}

TEST(FixedPoints, HoldOnlyTheAxesTheyAreAskedTo) {
    Scene s;
    const int block = s.box({0, 0}, 1, 1);
    for (const double y : {0.0, 1.0})
        s.model.fixed_points.push_back({s.material_point(block, {.5, y}), true, false});
    Simulation sim(s);
    ASSERT_EQ(sim.shake(.1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.moved(block).y(), -g * .01 / 2, 1e-12);
    EXPECT_NEAR(sim.moved(block).x(), 0, 1e-12);
}

/// A unit block under a fixed roof to which it is bonded over 1 m.
struct Bonded {
    Scene s;
    int block;
    explicit Bonded(double tensile_strength) {
        s.model.joint_materials[0].law = Scene::mohr_coulomb(30, 1e6, tensile_strength);
        s.box({-1, 1}, 3, 1, dda::Motion::fixed);
        block = s.box({0, 0}, 1, 1);
    }
};

// Each end of the bond carries half the weight: W over 1 m. The static stage overshoots by less than 10 %.
TEST(Bond, CarriesTheWeightOrBreaks) {
    Bonded strong(1.1 * weight);
    Simulation intact(strong.s);
    ASSERT_EQ(intact.settle(.005, 1e-9).status, dda::RunStatus::completed);
    double tension = 0;
    for (const dda::Contact& c : intact.state.contacts.contacts) tension -= c.normal_force;
    EXPECT_NEAR(tension, weight, 1e-3 * weight);
    EXPECT_LT(intact.moved(strong.block).norm(), 1e-5);

    Bonded weak(.9 * weight);
    Simulation broken(weak.s);
    ASSERT_EQ(broken.shake(.2, 1e-3).status, dda::RunStatus::completed);
    EXPECT_NEAR(broken.moved(weak.block).y(), -g * .04 / 2, .05 * g * .04 / 2);
    for (const dda::Contact& c : broken.state.contacts.contacts) EXPECT_FALSE(c.bonded);
}

}  // namespace
}  // namespace rockslope::constraints_test
