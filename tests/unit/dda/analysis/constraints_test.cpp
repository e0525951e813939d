// Bolts, fixed points and bonds: what holds a block that nothing else holds.

#include <gtest/gtest.h>

#include "support/scene.hpp"

using namespace rockslope;

namespace {

using namespace scene;

constexpr double weight = 2500 * g;
constexpr double axial_stiffness = 2e7;

/// A unit block hung by one bolt of 2 m from a fixed block above.
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

// The block hangs below the bolt's end, so that is a stable place, and the bolt bears all of the weight.
TEST(Bolt, BearsTheWeightOfAHungBlock) {
    Hung h;
    Simulation sim(h.s);
    ASSERT_EQ(sim.settle(.005, 1e-9).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.state.bolt_force[0], weight, 1e-6 * weight);
    const double elongation = sim.state.blocks.points[0].y() - sim.state.blocks.points[1].y() - 2;
    EXPECT_NEAR(elongation, weight * 2 / axial_stiffness, 1e-6 * elongation);
}

TEST(Bolt, PretensionEqualToTheWeightStretchesNoFarther) {
    Hung h(0, weight);
    Simulation sim(h.s);
    ASSERT_EQ(sim.settle(.005, 1e-9).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.state.bolt_force[0], weight, 1e-6 * weight);
    // What is left is the block's own strain between its centroid and the bolt's end, about W/(2 E).
    EXPECT_LT(sim.moved(h.block).norm(), 2 * weight / 10e9);
}

// A bolt that yields at half the weight lets the block fall at half of gravity, from the first step on if it
// starts there.
TEST(Bolt, YieldsAtItsYieldForce) {
    Hung h(weight / 2, weight / 2);
    Simulation sim(h.s);
    ASSERT_EQ(sim.shake(.1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.state.bolt_force[0], weight / 2, 1e-9 * weight);
    EXPECT_NEAR(sim.moved(h.block).y(), -g / 2 * .01 / 2, 1e-3 * g / 2 * .01 / 2);
    EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-6 * weight);
}

// Nor does a bolt that is all but slack in stiffness: its tension's rounding over that is no elongation.
TEST(Bolt, BelowItsYieldForceDissipatesNothing) {
    Hung h(0, 1e4);
    h.s.model.bolts[0].axial_stiffness = 1e-3;
    Simulation sim(h.s);
    ASSERT_EQ(sim.shake(.1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_LT(sim.moved(h.block).y(), -.01);
    EXPECT_EQ(sim.state.energy.friction_loss, 0);
}

TEST(FixedPoints, GiveByTheForceOverTheirStiffness) {
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

// Half the weight at either end of the bond: it must bear W over 1 m. The static approach does not overshoot
// by a tenth.
TEST(Bond, BearsTheWeightOrTears) {
    Bonded strong(1.1 * weight);
    Simulation held(strong.s);
    ASSERT_EQ(held.settle(.005, 1e-9).status, dda::RunStatus::completed);
    double tension = 0;
    for (const dda::Contact& c : held.state.contacts.contacts) tension -= c.normal_force;
    EXPECT_NEAR(tension, weight, 1e-3 * weight);
    EXPECT_LT(held.moved(strong.block).norm(), 1e-5);

    Bonded weak(.9 * weight);
    Simulation bond_broken(weak.s);
    ASSERT_EQ(bond_broken.shake(.2, 1e-3).status, dda::RunStatus::completed);
    EXPECT_NEAR(bond_broken.moved(weak.block).y(), -g * .04 / 2, .05 * g * .04 / 2);
    for (const dda::Contact& c : bond_broken.state.contacts.contacts) EXPECT_FALSE(c.bonded);
}

}  // namespace
