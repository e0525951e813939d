// A wall whose joints part as they are sheared, tipped so that it slides on itself: each joint's dilation
// presses on others, and the steps must not get shorter for that.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/cyclic_joints.hpp"
#include "support/walls.hpp"

using namespace rockslope;

namespace {

using namespace scene;

/// 1 m blocks of weak roughness, gravity leaning by an angle: 25 degrees of residual friction, 4 to 5 of
/// roughness for each power of ten between the stress and 100 MPa. @param youngs_modulus Pa, of the blocks,
/// and N/m per metre of the springs between them.
Scene tipped_wall(double damage, double degrees, double youngs_modulus = 5e9) {
    Scene s = running_bond_wall(6, 8, 1);
    dda::CyclicBartonBandis law;
    law.barton = {5, 100e6, radians(25)};
    law.peak_displacement = 5e-3;
    law.damage = damage;
    law.reversal_factor = .95;
    const dda::RoughnessTable wear = {{{0, 1}, {1, 1}, {2, .9}, {4, .7}, {8, .5}, {20, .2}}};
    law.cycles = {{wear, wear, wear, wear}};
    s.model.joint_materials[0].law = law;
    s.model.block_materials[0].youngs_modulus = youngs_modulus;
    s.model.normal_penalty = s.model.joint_materials[0].shear_penalty = youngs_modulus;
    s.model.gravity = g * Vec2(std::sin(radians(degrees)), -std::cos(radians(degrees)));
    return s;
}

struct Slid {
    double way = 0;    ///< m, of a block in the upper row
    int cuts = 0;      ///< steps taken again at a third
    double lost = 0;   ///< residual of the energy balance over the kinetic energy
    double left = 0;   ///< m, sum over the steps of the largest dilation left to the next one
    double apart = 0;  ///< m, the largest dilation at the end
};

Slid slid(double damage, double degrees, double step) {
    Simulation sim(tipped_wall(damage, degrees));
    EXPECT_EQ(sim.shake(.5, step).status, dda::RunStatus::completed);
    Slid slid;
    slid.way = sim.moved(sim.model.block_count() - 3).norm();
    for (const dda::StepReport& report : sim.reports) {
        slid.cuts += report.cuts;
        slid.left += report.remaining_dilation;
    }
    for (const dda::Contact& contact : sim.state.contacts.contacts)
        slid.apart = std::max(slid.apart, contact.dilation);
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

TEST(DilatingWall, IsHeldUpByWhatItClimbs) {
    EXPECT_LT(slid(1, 20, .005).way, .9 * slid(0, 20, .005).way);
}

// The variant that leaves all of it has 28 times as much.
TEST(DilatingWall, LeavesLittleOfItsDilationToTheNextStep) {
    EXPECT_EQ(slid(0, 20, .005).left, 0);
    const Slid rough = slid(1, 20, .005);
    EXPECT_GT(rough.left, 0);
    EXPECT_LT(rough.left, .15 * rough.apart) << "0.07 when this was written";
}

/// m, the mean over the wall's blocks in a quarter of a second.
double mean_displacement(const Scene& scene, double step) {
    Simulation sim(scene);
    EXPECT_EQ(sim.shake(.25, step).status, dda::RunStatus::completed);
    double sum = 0;
    for (int block = 1; block < sim.model.block_count(); ++block) sum += sim.moved(block).norm();
    return sum / (sim.model.block_count() - 1);
}

// Of soft blocks, whose strain the steps resolve: omega_contact dt is 2 in the longest and 0.1 in the
// shortest. The real wall's is 20, and each halving down to 0.04 ms lets some of the waves through that
// gravity's onset sends out and longer steps damp; they shake it on, with dilation and without it, and there
// is no order.
TEST(DilatingWall, HasAnErrorOfFirstOrderInTheStep) {
    for (const double degrees : {20., 30.}) {
        const Scene soft = tipped_wall(1, degrees, 5e7);
        std::vector<double> ways;
        for (const double step : {.01, .005, .0025, .00125, .000625})
            ways.push_back(mean_displacement(soft, step));
        for (std::size_t k = 2; k < ways.size(); ++k) {
            const double ratio = (ways[k] - ways[k - 1]) / (ways[k - 1] - ways[k - 2]);
            EXPECT_GT(ratio, 1. / 3) << degrees << ", " << k;
            EXPECT_LT(ratio, 2. / 3) << degrees << ", " << k;
        }
        EXPECT_NEAR(ways[1], ways.back(), .015 * ways.back()) << "1.0 % at 5 ms when this was written";
    }
}

}  // namespace
