// A wall whose joints part as they are sheared, tipped so that it slides on itself: each joint's dilation
// presses on others, and the steps must not get shorter for that.

#include <gtest/gtest.h>

#include "support/cyclic_joints.hpp"
#include "support/walls.hpp"

namespace {

using namespace scene;

/// 1 m blocks of weak roughness, gravity leaning by an angle: 25 degrees of residual friction, 4 to 5 of
/// roughness for each power of ten between the stress and 100 MPa.
Scene tipped_wall(double damage, double degrees) {
    Scene s = running_bond_wall(6, 8, 1);
    dda::CyclicBartonBandis law;
    law.barton = {5, 100e6, radians(25)};
    law.peak_displacement = 5e-3;
    law.damage = damage;
    law.reversal_factor = .95;
    const dda::RoughnessTable wear = {{{0, 1}, {1, 1}, {2, .9}, {4, .7}, {8, .5}, {20, .2}}};
    law.cycles = {{wear, wear, wear, wear}};
    s.model.joint_materials[0].law = law;
    s.model.joint_materials[0].shear_penalty = 5e9;
    s.model.gravity = g * Vec2(std::sin(radians(degrees)), -std::cos(radians(degrees)));
    return s;
}

struct Slid {
    double way = 0;   ///< m, of a block in the upper row
    int cuts = 0;     ///< steps taken again at a third
    double lost = 0;  ///< residual of the energy balance over the kinetic energy
};

Slid slid(double damage, double degrees, double step) {
    Simulation sim(tipped_wall(damage, degrees));
    EXPECT_EQ(sim.shake(.5, step).status, dda::RunStatus::completed);
    Slid slid;
    slid.way = sim.moved(sim.model.block_count() - 3).norm();
    for (const dda::StepReport& report : sim.reports) slid.cuts += report.cuts;
    slid.lost = std::abs(sim.state.energy.residual()) / sim.state.energy.kinetic;
    return slid;
}

// When all of a step's dilation had to be found within it, one step in ten was cut at 35 degrees.
TEST(DilatingWall, SlidesWithoutShorterSteps) {
    for (const double degrees : {20., 35.}) {
        const Slid rough = slid(1, degrees, .005);
        EXPECT_LE(rough.cuts, 4) << degrees << ": of 100 steps";
        EXPECT_LT(rough.lost, 1e-5) << degrees;
    }
}

// What a step leaves to the next is of the order of the step.
TEST(DilatingWall, SlidesAsFarInShorterSteps) {
    const Slid even = slid(0, 20, .005);
    const Slid coarse = slid(1, 20, .005);
    const Slid fine = slid(1, 20, .00125);

    EXPECT_NEAR(coarse.way, fine.way, .01 * fine.way) << "0.6 % when this was written";
    EXPECT_LT(fine.way, .9 * even.way) << "what climbs is held up";
}

}  // namespace
