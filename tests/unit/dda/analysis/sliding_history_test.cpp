// A sliding contact keeps its history over collinear edges, over a redundant vertex and onto a neighbour's
// face.

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::sliding_history_test {
namespace {

using namespace scene;

/// A block of 1 m slides at 0.5 m/s over a floor with upper face y = 0 and friction angle 30 degrees. A body
/// force balances friction. The friction force must not jump, and no spring energy may be released.
void expect_smooth_slide(Scene s, int slider) {
    s.friction(30);
    const double weight = 2500 * g;
    const double friction = weight * std::tan(radians(30));
    s.model.gravity = {g * std::tan(radians(30)), -g};
    Simulation sim(s);
    ASSERT_EQ(sim.settle(.005, 1e-7).status, dda::RunStatus::completed);
    sim.velocity(slider)[0] = .5;
    sim.restart_ledger();
    double smallest = 1e300;
    double largest = 0;
    int steps = 0;
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        double shear = 0;
        for (const dda::Contact& c : state.contacts.contacts) {
            if (c.corner_block != slider && c.edge_block != slider) continue;
            const double sign = c.corner_block == slider ? 1 : -1;
            shear += sign * c.shear_force * c.tangent.x();
        }
        if (++steps < 20) return;  // the start from rest
        smallest = std::min(smallest, shear);
        largest = std::max(largest, shear);
    };
    ASSERT_EQ(sim.shake(2, .002).status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.moved(slider).x(), 1, .01);
    // The tolerance allows for elastic strain: stresses of 2e4 Pa in rock of 1e10 Pa.
    EXPECT_NEAR(smallest, friction, .01 * friction);
    EXPECT_NEAR(largest, friction, .01 * friction);
    EXPECT_LT(std::abs(sim.state.energy.released), 1e-6 * sim.state.energy.friction_loss);
}

TEST(SlidingHistory, OverANeighboursFace) {
    Scene s;
    for (int k = 0; k < 6; ++k) s.box({.7 * k - 1, -1}, .7, 1, dda::Motion::fixed);
    const int slider = s.box({0, 0}, 1, 1);
    expect_smooth_slide(s, slider);
}

TEST(SlidingHistory, OverCollinearEdgesOfOneBlock) {
    Scene s;
    s.block({{{-1, -1}, {4, -1}, {4, 0}, {2.6, 0}, {1.3, 0}, {.55, 0}, {-1, 0}}}, dda::Motion::fixed);
    const int slider = s.box({0, 0}, 1, 1);
    expect_smooth_slide(s, slider);
}

TEST(SlidingHistory, WithARedundantVertexOfItsOwn) {
    Scene s;
    for (int k = 0; k < 6; ++k) s.box({.7 * k - 1, -1}, .7, 1, dda::Motion::fixed);
    const int slider = s.block({{{0, 0}, {.37, 0}, {1, 0}, {1, 1}, {0, 1}}});
    expect_smooth_slide(s, slider);
}

}  // namespace
}  // namespace rockslope::sliding_history_test
