// A block on a viscous boundary: springs hold it in the static stage, their reactions support it in the
// dynamic stage, and the dashpots slow it down.

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::viscous_boundary_test {
namespace {

using namespace scene;

constexpr double weight = 2500 * g;

struct OnDashpots {
    Scene s;
    int block;
    explicit OnDashpots(double impedance, dda::Hold hold = dda::Hold::both) {
        block = s.box({0, 0}, 1, 1);
        s.model.viscous_boundaries.push_back({"below", {{0, 0, 1}}, impedance, impedance, hold});
    }
};

Vec2 sum(const dda::BoundaryReactions& reactions) {
    Vec2 total = Vec2::Zero();
    for (const Vec2& reaction : reactions) total += reaction;
    return total;
}

// Two springs hold the base, which sinks by W / (2 k). In the dynamic stage their reaction is a load, and the
// block stays at rest. If the dashpots carried the weight, it would sink by W t / (z L), 2 mm here.
TEST(ViscousBoundary, ReactionsOfTheStaticStageSupportTheModel) {
    const OnDashpots made(5e6);
    Simulation sim(made.s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    EXPECT_NEAR(sum(sim.state.boundary_reactions).y(), weight, 1e-6 * weight);
    EXPECT_NEAR(sum(sim.state.boundary_reactions).x(), 0, 1e-6 * weight);
    const double sinking = weight / (2 * made.s.model.fixed_point_penalty);
    EXPECT_NEAR(sim.state.blocks.vertices[0].y(), -sinking, 1e-3 * sinking);
    ASSERT_EQ(sim.shake(0.5, 1e-3).status, dda::RunStatus::completed);
    EXPECT_LT(sim.moved(made.block).norm(), 1e-9);
    EXPECT_NEAR(sum(sim.state.boundary_reactions).y(), weight, 1e-6 * weight);
    EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-3 * weight * sinking);
}

TEST(ViscousBoundary, HoldsOnlyTheNormalDirectionIfAsked) {
    OnDashpots made(5e6, dda::Hold::normal);
    made.s.model.gravity = {1, -g};
    Simulation sim(made.s);
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    stage.step_limit = 20;
    EXPECT_EQ(sim.run(stage).status, dda::RunStatus::not_settled) << "no spring holds it in x";
    EXPECT_NEAR(sum(sim.state.boundary_reactions).y(), weight, 1e-3 * weight);
    EXPECT_EQ(sum(sim.state.boundary_reactions).x(), 0);
}

// m v' = -z L v: the velocity decays by a factor e in m / (z L) = 0.1 s. The integration is first-order, and
// the step is a thousandth of that time.
TEST(ViscousBoundary, SlowsARigidBlockDown) {
    OnDashpots made(25000);
    made.s.model.gravity.setZero();
    for (const int axis : {0, 1}) {
        Simulation sim(made.s);
        sim.velocity(made.block)[axis] = 1e-2;
        sim.restart_ledger();
        const double kinetic = sim.state.energy.kinetic;
        ASSERT_EQ(sim.shake(0.1, 1e-4).status, dda::RunStatus::completed);
        const dda::Energy& e = sim.state.energy;
        if (axis == 1) {
            EXPECT_NEAR(sim.velocity(made.block)[axis], 1e-2 * std::exp(-1), 1e-3 * 1e-2);
            EXPECT_NEAR(e.boundary_loss, kinetic * (1 - std::exp(-2)), 1e-3 * kinetic);
        }
        EXPECT_GT(e.boundary_loss, 0.5 * kinetic);
        EXPECT_LT(std::abs(e.residual()), 1e-6 * kinetic);
    }
}

}  // namespace
}  // namespace rockslope::viscous_boundary_test
