// Impacts between blocks.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::impact_test {
namespace {

using namespace scene;
using namespace verification;

// V29. Head-on impact of two equal frictionless blocks. Contact forces are equal and opposite, so momentum is
// conserved up to rounding for any energy loss. The bound is relative to the momentum of one block.
TEST(Collision, ConservesMomentum) {
    Scene s;
    s.model.gravity.setZero();
    const int left = s.box({0, 0}, 1, 1);
    const int right = s.box({1.01, 0}, 1, 1);
    Simulation sim(s);
    sim.velocity(left)[0] = 1;
    sim.velocity(right)[0] = -1;
    sim.restart_ledger();
    const auto momentum = [&] {
        return 2500 * (sim.velocity(left).head<2>() + sim.velocity(right).head<2>());
    };
    ASSERT_EQ(sim.shake(0.05, 1e-4).status, dda::RunStatus::completed);
    EXPECT_LT(sim.velocity(left)[0], 0) << "the blocks must have rebounded";
    const std::string set_up = "two squares at ±1 m/s";
    Case("V29", set_up, "contact forces come in pairs: rounding is left")
        .contact_frequency_step(sim.contact_frequency_step())
        .expect_below("momentum over that of one block", "", momentum().norm() / 2500, 1e-8);
    expect_energy_balance("V29", set_up, sim);
}

/// The rebound speed of a unit mass that hits a unilateral spring at unit speed, by Newmark's relations in
/// unit steps.
/// @param w omega dt; @param gap the distance to the spring at the start, which sets the phase of the impact.
double restitution_of_recurrence(double w, double beta, double gamma, double gap) {
    double x = gap;
    double v = -1;
    double a = 0;
    bool met = false;
    while (!met || x < 0 || a != 0) {
        const double predicted = x + v + (.5 - beta) * a;
        x = predicted < 0 ? predicted / (1 + beta * w * w) : predicted;
        const double next = x < 0 ? -w * w * x : 0;
        v += (1 - gamma) * a + gamma * next;
        a = next;
        met = met || x < 0;
    }
    return v;
}

struct ImpactCase {
    double w_dt, beta, gamma, restitution, tolerance;
    friend std::ostream& operator<<(std::ostream& out, const ImpactCase& c) {
        return out << c.beta << "_" << c.w_dt;
    }
};
class Restitution : public testing::TestWithParam<ImpactCase> {};

// V26. A stiff undamped block hits a fixed wall face to face on two springs, omega = sqrt(2 k_n/m). The
// recurrence at the same phase is exact for a rigid block. The tolerance of 1e-3 allows for the block's
// stiffness, a thousand times that of the springs. The values of the table hold for any phase.
TEST_P(Restitution, IsThatOfTheRecurrence) {
    const ImpactCase& c = GetParam();
    const double dt = 1e-3;
    Scene s;
    s.model.gravity.setZero();
    s.model.block_materials[0].damping_ratio = 0;
    const double frequency = c.w_dt / dt;
    s.model.normal_penalty = s.model.shear_penalty = 2500 * frequency * frequency / 2;
    s.model.block_materials[0].youngs_modulus = 1e4 * s.model.normal_penalty;
    const double speed = .01;
    const double gap = 1.5 * speed * dt;
    s.box({-1, -1}, 1, 3, dda::Motion::fixed);
    const int block = s.box({gap, 0}, 1, 1);
    Simulation sim(s);
    sim.velocity(block)[0] = -speed;
    sim.restart_ledger();
    dda::Stage stage;
    stage.name = "impact";
    stage.duration = (4 + std::ceil(4 / c.w_dt)) * dt;
    stage.control.step = dt;
    stage.newmark_beta = c.beta;
    stage.newmark_gamma = c.gamma;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    ASSERT_GT(sim.moved(block).x(), -gap) << "the block must have left the wall";
    const double kept = sim.velocity(block)[0] / speed;
    const std::string set_up =
        "Newmark (" + to_text(c.beta) + ", " + to_text(c.gamma) + "), ω Δt = " + to_text(c.w_dt);
    expect_energy_balance("V26", set_up, sim);
    Case exact("V26", set_up, "the block is a thousand times stiffer than the springs");
    exact.contact_frequency_step(sim.contact_frequency_step());
    exact.expect("restitution at this phase", "", kept,
                 restitution_of_recurrence(c.w_dt, c.beta, c.gamma, 1.5), absolute(1e-3));
    Case table("V26", set_up, "required, or the range over the phases where that is wider");
    table.contact_frequency_step(sim.contact_frequency_step());
    table.expect("restitution", "", kept, c.restitution, absolute(c.tolerance));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Restitution,
                         testing::Values(ImpactCase{.01, .5, 1, .992, .02}, ImpactCase{.05, .5, 1, .961, .02},
                                         ImpactCase{.1, .5, 1, .925, .02}, ImpactCase{.2, .5, 1, .855, .02},
                                         ImpactCase{.5, .5, 1, .685, .02}, ImpactCase{2, .5, 1, .333, .02},
                                         ImpactCase{.01, .25, .5, 1, .01}, ImpactCase{.05, .25, .5, 1, .01},
                                         ImpactCase{.1, .25, .5, 1, .01}, ImpactCase{.2, .25, .5, 1, .01},
                                         ImpactCase{1, .25, .5, 1, .11}));

}  // namespace
}  // namespace rockslope::impact_test
