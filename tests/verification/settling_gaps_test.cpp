// Slabs of 0.2 m by 2 m that lean by 0.2 rad, and one that is a little out of plumb, in a static stage: they
// turn over an edge without inertia. Each step turns them by some hundredths, and predicts that they do not
// turn. Gaps that are linear about that prediction do not settle at the gaps of the solution, and the step is
// repeated about the mid-step that was found. Where GapSettling never asks for that, a step takes up to 112
// iterations instead of 34.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/scene.hpp"

namespace rockslope::settling_gaps_test {
namespace {

using namespace scene;

constexpr double width = 0.2, height = 2, out_of_plumb = 0.02;  ///< m, m, rad

// No slab rises, none enters the floor by more than its springs yield, and the one that is out of plumb comes
// to stand.
TEST(SettlingGaps, SlabsThatTurnOverInAStaticStage) {
    Scene s;
    s.friction(25);
    s.box({-6, -1}, 18, 1, dda::Motion::fixed);
    s.box({0, 0}, width, height, dda::Motion::free, 0.2);
    s.box({-1.2, 0}, width, height, dda::Motion::free, -0.2);
    s.box({2, 0}, width, height, dda::Motion::free, out_of_plumb);
    Simulation sim(s);
    double gravity = sim.state.energy.gravity, highest_rise = 0, deepest = 0;
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        highest_rise = std::max(highest_rise, state.energy.gravity - gravity);
        gravity = state.energy.gravity;
        for (const dda::Contact& contact : state.contacts.contacts)
            if (contact.state != dda::ContactState::open) deepest = std::max(deepest, -contact.gap);
    };
    dda::Stage settle;
    settle.name = "settle";
    settle.kind = dda::StageKind::static_equilibrium;
    settle.control.step = 0.05;
    settle.step_limit = 150;
    sim.run(settle);
    int most = 0, sum = 0;
    for (const dda::StepReport& report : sim.reports) {
        most = std::max(most, report.iterations);
        sum += report.iterations;
        EXPECT_EQ(report.cuts, 0);
    }
    EXPECT_LE(most, 60);
    EXPECT_LE(sum, 1700);
    EXPECT_LE(highest_rise, 1e-6 * 2500 * g * width * height) << "J per metre, by a micrometre";
    EXPECT_LT(deepest, 1e-6) << "the weight of a slab yields 0.2 micrometres";
    for (const int leaning : {1, 2}) EXPECT_LT(sim.moved(leaning).y(), -0.05) << leaning;
    // Its centre is half a slab from the corner about which it turns.
    const Vec2 centre(width / 2, height / 2);
    const double c = std::cos(out_of_plumb), sine = std::sin(out_of_plumb);
    const Vec2 leant(c * centre.x() - sine * centre.y(), sine * centre.x() + c * centre.y());
    EXPECT_LT((sim.moved(3) - (centre - leant)).norm(), 1e-5);
}

}  // namespace
}  // namespace rockslope::settling_gaps_test
