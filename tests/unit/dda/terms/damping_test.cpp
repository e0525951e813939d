// Mass-proportional damping with Newmark's relations, against a recurrence derived by hand.

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::damping_test {
namespace {

using namespace scene;

struct NewmarkCase {
    double beta, gamma;
};
class MassDamping : public testing::TestWithParam<NewmarkCase> {};

// A free block has M a1 + alpha M v1 = 0 at the end of each step: v1 = (v0 + (1 - gamma) dt a0) / (1 + gamma
// alpha dt) and a1 = -alpha v1. It moves by dt v0 + dt^2 ((1/2 - beta) a0 + beta a1). With (1/2, 1) the
// velocity is v0 / (1 + alpha dt)^n. The energy balance must book the lost kinetic energy as damping loss.
TEST_P(MassDamping, SlowsABlockByTheRecurrence) {
    const auto [beta, gamma] = GetParam();
    Scene s;
    s.model.gravity.setZero();
    const int block = s.box({0, 0}, 1, 1);
    Simulation sim(s);
    sim.velocity(block)[0] = 0.1;
    sim.restart_ledger();
    dda::Stage stage;
    stage.duration = 0.5;
    stage.control.step = 0.01;
    stage.mass_damping = 2;
    stage.newmark_beta = beta;
    stage.newmark_gamma = gamma;
    const double kinetic = sim.state.energy.kinetic;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    double x = 0;
    double v = 0.1;
    double a = 0;
    for (int k = 0; k < 50; ++k) {
        const double v1 = (v + (1 - gamma) * 0.01 * a) / (1 + gamma * 2 * 0.01);
        const double a1 = -2 * v1;
        x += 0.01 * v + 0.01 * 0.01 * ((0.5 - beta) * a + beta * a1);
        v = v1;
        a = a1;
    }
    EXPECT_NEAR(sim.velocity(block)[0], v, 1e-12);
    EXPECT_NEAR(sim.moved(block).x(), x, 1e-12);
    EXPECT_NEAR(v, 0.1 * std::exp(-1), 0.002) << "the exponential, to first order in the step";
    EXPECT_GT(sim.state.energy.damping_loss, 0.8 * kinetic);
    EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-9 * kinetic);
}

INSTANTIATE_TEST_SUITE_P(Parameters, MassDamping,
                         testing::Values(NewmarkCase{0.5, 1}, NewmarkCase{0.25, 0.5}));

}  // namespace
}  // namespace rockslope::damping_test
