// Joints with cohesion and without tensile strength: every step has a solution, so walls settle.

#include <gtest/gtest.h>

#include "support/walls.hpp"

namespace rockslope::cohesion_test {
namespace {

using namespace scene;

// --- cohesion without a normal force

/// A block of 1 m between two fixed walls. Its joints with the walls bear no normal force, so it hangs on
/// their cohesion alone: on 2 c h against its weight. @return how far it has sunk after 50 static steps, m.
double sunk_between_walls(double cohesion) {
    Scene s;
    s.model.joint_materials[0].law = Scene::mohr_coulomb(30, cohesion);
    s.box({-1, -1}, 1, 3, dda::Motion::fixed);
    s.box({1, -1}, 1, 3, dda::Motion::fixed);
    const int block = s.box({0, 0}, 1, 1);
    Simulation sim(s);
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    stage.step_limit = 50;
    stage.control.step = .005;
    sim.run(stage);
    return -sim.moved(block).y();
}

// The springs give way by W / (4 k) = 0.1 um; the block hangs on both sides, and its strain adds less than 1
// nm. Without cohesion the block sinks by g dt^2 / 2 = 0.12 mm a step at least. Cohesion that vanished with
// the normal force would hold it at no strength.
TEST(Cohesion, HoldsABlockThatBearsNoNormalForce) {
    const double weight = 2500 * g;
    EXPECT_NEAR(sunk_between_walls(1.02 * weight / 2), weight / (4 * 5e10), 1e-9);
    EXPECT_GT(sunk_between_walls(.98 * weight / 2), 1e-3);
}

// --- settling

struct Settled {
    dda::RunStatus status = dda::RunStatus::not_settled;
    int cuts = 0;
    int iterations = 0;
};

/// Settles a wall of 8 by 8 m in running bond on a base tilted by `degrees`. Friction of 35 degrees.
Settled settled(double degrees, double cohesion, double residual_cohesion) {
    Scene s = running_bond_wall(8, 8, 4);
    dda::MohrCoulomb law = Scene::mohr_coulomb(35, cohesion);
    law.residual_cohesion = residual_cohesion;
    s.model.joint_materials[0].law = law;
    s.model.gravity = g * Vec2(std::sin(radians(degrees)), -std::cos(radians(degrees)));
    Simulation sim(s);
    dda::Stage stage;
    stage.name = "settle";
    stage.kind = dda::StageKind::static_equilibrium;
    stage.step_limit = 1000;
    stage.control.step = .02;
    Settled result;
    result.status = sim.run(stage).status;
    for (const dda::StepReport& report : sim.reports) {
        result.cuts += report.cuts;
        result.iterations += report.iterations;
    }
    return result;
}

// Where cohesion vanished with the normal force, 20 kPa at 10 degrees took two cuts and 235 iterations.
TEST(CohesiveWall, ComesToRestWithAnyCohesion) {
    for (const double degrees : {0., 5., 10.}) {
        for (const double cohesion : {0., 1e3, 5e3, 20e3, 100e3, 500e3}) {
            for (const double residual : {0., cohesion}) {
                const Settled wall = settled(degrees, cohesion, residual);
                const std::string name = std::to_string(degrees) +
                                         " degrees, c = " + std::to_string(cohesion) + ", residual " +
                                         std::to_string(residual);
                EXPECT_EQ(wall.status, dda::RunStatus::completed) << name;
                EXPECT_EQ(wall.cuts, 0) << name;
                EXPECT_LE(wall.iterations, 60) << name << ": 38 at most when this was written";
            }
        }
    }
}

// --- energy

// The shear force of a contact that opens acts to the end of the step, and its work belongs into the ledger:
// without it 5e-4 and 5e-3 of the kinetic energy are missing. A step balances its forces to 1e-6, so the work
// of its forces is known to 1e-6; 5e-9 without cohesion and 1e-7 with it were seen.
TEST(CohesiveWall, BalancesTheEnergyOfContactsThatOpen) {
    for (const double cohesion : {0.0, 5e3, 20e3}) {
        Scene s = running_bond_wall(6, 8, 1);
        dda::MohrCoulomb law = Scene::mohr_coulomb(25, cohesion);
        law.residual_cohesion = cohesion;
        s.model.joint_materials[0].law = law;
        s.model.gravity = g * Vec2(std::sin(radians(40)), -std::cos(radians(40)));
        Simulation sim(s);
        int opened_with_shear = 0;
        std::vector<dda::Contact> before;
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
            for (const dda::Contact& old : before) {
                if (old.state == dda::ContactState::open || old.shear_force == 0) continue;
                for (const dda::Contact& contact : state.contacts.contacts)
                    if (contact.corner == old.corner && contact.edge == old.edge &&
                        contact.state == dda::ContactState::open)
                        ++opened_with_shear;
            }
            before.assign(state.contacts.contacts.begin(), state.contacts.contacts.end());
        };
        ASSERT_EQ(sim.shake(.5, .005).status, dda::RunStatus::completed);
        EXPECT_GT(opened_with_shear, 100) << "the case that the test is about";
        EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-6 * sim.state.energy.kinetic) << cohesion;
    }
}

}  // namespace
}  // namespace rockslope::cohesion_test
