// A running-bond wall of 2500 blocks released from rest, with steps of 5 ms and a penalty of 10 E.

#include <gtest/gtest.h>

#include <cstdio>

#include "support/walls.hpp"

namespace rockslope::wall_test {
namespace {

using namespace scene;

TEST(Wall, ComesToRestInFewIterationsWithoutCuts) {
    Simulation sim(running_bond_wall(50, 50, 10));
    int cuts = 0;
    double next = 1;
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
        if (state.time > 1) cuts += report.cuts;
        if (state.time < next - 1e-9) return;
        std::printf("%2.0f s: %zu steps, %.2f iterations each, kinetic %.3g J\n", state.time,
                    sim.reports.size(), sim.mean_iterations(), state.energy.kinetic);
        std::fflush(stdout);
        next += 1;
    };
    const dda::RunOutcome outcome = sim.shake(10, .005);
    ASSERT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    EXPECT_EQ(cuts, 0) << "after the first second";
    EXPECT_LT(sim.mean_iterations(), 4);
}

}  // namespace
}  // namespace rockslope::wall_test
