// A tilted wall with dilating joints that slides along its bed joints. The dilation of each joint loads
// others; this must not cause step cuts.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/cyclic_joints.hpp"
#include "support/walls.hpp"

namespace rockslope::dilating_wall_test {
namespace {

using namespace scene;

/// 1 m blocks with weakly rough joints under inclined gravity. The residual friction angle is 25 degrees; the
/// roughness adds 4 to 5 degrees for each power of ten between the stress and 100 MPa.
/// @param degrees inclination of gravity; @param youngs_modulus Pa, of the blocks; also the spring stiffness
/// in N/m per metre
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
    double displacement = 0;        ///< m, of a block in the upper row
    int cuts = 0;                   ///< number of rejected steps
    double energy_error = 0;        ///< residual of the energy balance over the kinetic energy
    double remaining_dilation = 0;  ///< m, sum over the steps of the largest dilation left to the next step
    double largest_dilation = 0;    ///< m, at the end
};

Slid slid(double damage, double degrees, double step) {
    Simulation sim(tipped_wall(damage, degrees));
    EXPECT_EQ(sim.shake(.5, step).status, dda::RunStatus::completed);
    Slid slid;
    slid.displacement = sim.moved(sim.model.block_count() - 3).norm();
    for (const dda::StepReport& report : sim.reports) {
        slid.cuts += report.cuts;
        slid.remaining_dilation += report.remaining_dilation;
    }
    for (const dda::Contact& contact : sim.state.contacts.contacts)
        slid.largest_dilation = std::max(slid.largest_dilation, contact.dilation);
    slid.energy_error = std::abs(sim.state.energy.residual()) / sim.state.energy.kinetic;
    return slid;
}

// When all dilation of a step had to converge within the step, one step in ten was cut at 35 degrees.
TEST(DilatingWall, SlidesWithFewCuts) {
    for (const double degrees : {20., 35.}) {
        const Slid rough = slid(1, degrees, .005);
        EXPECT_LE(rough.cuts, 4) << degrees << " degrees, of 100 steps";
        EXPECT_LT(rough.energy_error, 1e-5) << degrees;
    }
}

TEST(DilatingWall, SlidesLessThanASmoothWall) {
    EXPECT_LT(slid(1, 20, .005).displacement, .9 * slid(0, 20, .005).displacement);
}

// If all dilation were postponed, the remaining dilation would be 28 times as large.
TEST(DilatingWall, LeavesLittleDilationToTheNextStep) {
    EXPECT_EQ(slid(0, 20, .005).remaining_dilation, 0);
    const Slid rough = slid(1, 20, .005);
    EXPECT_GT(rough.remaining_dilation, 0);
    EXPECT_LT(rough.remaining_dilation, .15 * rough.largest_dilation) << "0.07 when this was written";
}

/// The mean displacement of the blocks in a quarter of a second, m, after they came to rest under vertical
/// gravity.
double mean_displacement(const Scene& scene, double step) {
    Scene level = scene;
    level.model.gravity = Vec2(0, -g);
    Simulation rest(level), sim(scene);
    EXPECT_EQ(rest.settle(.005, 1e-6).status, dda::RunStatus::completed);
    sim.state = rest.state;
    EXPECT_EQ(sim.shake(.25, step).status, dda::RunStatus::completed);
    double sum = 0;
    for (int block = 1; block < sim.model.block_count(); ++block) sum += sim.moved(block).norm();
    return sum / (sim.model.block_count() - 1);
}

// The blocks are so soft that the steps resolve their strain: omega_contact dt is 2 in the largest step and
// 0.1 in the smallest. For the stiff wall it is 20. There each halving of the step down to 0.04 ms resolves
// more of the waves that the sudden gravity causes and that larger steps damp. These waves move the wall with
// and without dilation, and no order of convergence can be seen.
TEST(LongDilatingWall, HasAnErrorOfFirstOrderInTheStep) {
    for (const double degrees : {40., 45.}) {
        const Scene soft = tipped_wall(1, degrees, 5e7);
        std::vector<double> displacements;
        for (const double step : {.01, .005, .0025, .00125, .000625})
            displacements.push_back(mean_displacement(soft, step));
        // Steps of 10 and 2.5 ms against 0.625 ms: an error proportional to the step gives (16 - 1) / (4 -
        // 1).
        const double ratio = (displacements[0] - displacements[4]) / (displacements[2] - displacements[4]);
        EXPECT_GT(ratio, 3) << degrees << ": order 0.7";
        EXPECT_LT(ratio, 8) << degrees << ": order 1.4";
        EXPECT_NEAR(displacements[1], displacements.back(), .015 * displacements.back())
            << "0.8 % at 5 ms when this was written";
    }
}

}  // namespace
}  // namespace rockslope::dilating_wall_test
