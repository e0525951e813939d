// A tipped wall whose joints yield from the start of their loading. All of them slide a little until it
// rests, and how far depends on how their bounds grow as they slide.

#include <gtest/gtest.h>

#include <cmath>

#include "support/walls.hpp"

namespace rockslope::yielding_wall_test {
namespace {

using namespace scene;

Scene tipped_wall(double degrees) {
    Scene s = running_bond_wall(10, 8, 1);
    s.model.joint_materials[0].law = dda::ContinuouslyYielding{radians(32), radians(28), 2e-3};
    s.model.gravity = g * Vec2(std::sin(radians(degrees)), -std::cos(radians(degrees)));
    return s;
}

// With bounds that stay as they are while a joint slides, none of these walls settled within a minute. Now
// the steepest takes 41 steps, 644 iterations and three cuts, for it grows its step until one does not
// converge.
TEST(YieldingWall, Settles) {
    for (const double degrees : {4.0, 8.0, 12.0, 14.0}) {
        SCOPED_TRACE(degrees);
        Simulation sim(tipped_wall(degrees));
        EXPECT_EQ(sim.settle(0.005, 1e-7).status, dda::RunStatus::completed);
        int iterations = 0, cuts = 0;
        for (const dda::StepReport& report : sim.reports) {
            iterations += report.iterations;
            cuts += report.cuts;
        }
        EXPECT_LE(sim.reports.size(), 80u);
        EXPECT_LE(iterations, 1200);
        EXPECT_LE(cuts, 6);
    }
}

}  // namespace
}  // namespace rockslope::yielding_wall_test
