#include "dda/analysis/bonds.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "dda/analysis/run_stage.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::bonds_test {
namespace {

using namespace scene;

constexpr double weight = 2500 * g;  // N per metre, of a block of 1 m2

/// A block of 1 m x 1 m on a plane that dips by `dip`, deg, glued to it by a cohesion. The slope falls to the
/// left, the block is number 1.
struct GluedBlock {
    Scene scene;
    dda::Stage stage;

    GluedBlock(double dip, double cohesion, double tensile_strength = 0) {
        const double angle = radians(dip);
        const Ring base{{-3, -1}, {4, -1}, {4, 0}, {-3, 0}}, block{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        scene.block({placed(base, angle, {0, 0})}, dda::Motion::fixed);
        scene.block({placed(block, angle, {0, 0})});
        dda::MohrCoulomb law;
        law.friction_angle = law.residual_friction_angle = radians(30);
        law.cohesion = cohesion;
        law.tensile_strength = tensile_strength;
        scene.model.joint_materials[0].law = law;
        stage.kind = dda::StageKind::static_equilibrium;
        stage.control.step = 0.02;
        stage.displacement_limit = 0.2;
        stage.bonds_break_at_rest = true;
    }
    /// The cohesion of limit equilibrium, Pa on 1 m: W (sin a - cos a tan phi).
    static double needed(double dip) {
        const double angle = radians(dip);
        return weight * (std::sin(angle) - std::cos(angle) * std::tan(radians(30)));
    }
};

// The cohesion of limit equilibrium decides, on planes on which friction alone does not hold.
TEST(Bonds, HoldWhatLimitEquilibriumHolds) {
    for (const double dip : {35.0, 45.0, 55.0}) {
        for (const double share : {1.01, 1.5, 0.99}) {
            GluedBlock glued(dip, share * GluedBlock::needed(dip), 5 * weight);
            Simulation sim(glued.scene);
            const bool holds = sim.run(glued.stage).status == dda::RunStatus::completed;
            EXPECT_EQ(holds, share > 1) << dip << ' ' << share;
            EXPECT_EQ(sim.state.broken_bonds.events > 0, share < 1) << dip << ' ' << share;
        }
    }
}

// Joints without cohesion have no bonds, whatever the stage asks for.
TEST(Bonds, HoldInAStageThatAsksForIt) {
    GluedBlock glued(40, 2 * GluedBlock::needed(40));
    EXPECT_TRUE(dda::bonds_hold(glued.scene.model, glued.stage));
    glued.scene.model.joint_materials[0].law = Scene::mohr_coulomb(30);
    EXPECT_FALSE(dda::bonds_hold(glued.scene.model, glued.stage));
    glued.scene.model.joint_materials[0].law = dda::Elastic();
    EXPECT_FALSE(dda::bonds_hold(glued.scene.model, glued.stage)) << "glued for good";
    GluedBlock at_once(40, 1e5);
    at_once.stage.bonds_break_at_rest = false;
    EXPECT_FALSE(dda::bonds_hold(at_once.scene.model, at_once.stage));
}

TEST(Bonds, YieldAtFourFifthsOfTheirStrengthUntilTheyMove) {
    dda::PerContact<dda::Contact> contacts(4);
    const std::vector<double> strains{0, 0.25, 0.5, 0.9}, shares{0.8, 0.9, 1, 1};
    for (const dda::ContactIndex k : contacts.indices()) contacts[k].bond_strain = strains[k.value()];
    GluedBlock glued(40, 1e5);
    for (dda::Contact& contact : contacts) contact.joint_material = dda::JointMaterialIndex(0);
    const auto held = dda::held_shares(glued.scene.model, contacts);
    for (const dda::ContactIndex k : contacts.indices()) EXPECT_DOUBLE_EQ(held[k], shares[k.value()]);
}

// A block near the limit rests by all of the strength of its two bonds, one well below it by a part.
TEST(Bonds, AreStrainedNearTheLimit) {
    for (const double share : {1.001, 1.1, 2.0}) {
        GluedBlock glued(45, share * GluedBlock::needed(45), 5 * weight);
        Simulation sim(glued.scene);
        ASSERT_EQ(sim.run(glued.stage).status, dda::RunStatus::completed) << share;
        EXPECT_EQ(sim.state.strained_bonds.of, 2) << share;
        EXPECT_EQ(sim.state.strained_bonds.contacts, share < 1.01 ? 2 : 0) << share;
        dda::begin_stage(sim.state);
        EXPECT_EQ(sim.state.strained_bonds.of, 0) << "of a stage before";
    }
}

// A bond whose residual strength is that of its peak has nothing to lose.
TEST(Bonds, AreNotStrainedWhereTheyLoseNoStrength) {
    const double cohesion = 1.001 * GluedBlock::needed(45);
    GluedBlock glued(45, cohesion);
    dda::MohrCoulomb law;
    law.friction_angle = law.residual_friction_angle = radians(30);
    law.cohesion = law.residual_cohesion = cohesion;
    glued.scene.model.joint_materials[0].law = law;
    Simulation sim(glued.scene);
    ASSERT_EQ(sim.run(glued.stage).status, dda::RunStatus::completed);
    EXPECT_EQ(dda::strained_bonds(glued.scene.model, sim.state).of, 0);
}

// A block that hangs from its bonds at their tensile strength: the spring of the next stage bears that force
// at the gap that the bonds have opened, and none more.
TEST(Bonds, BearTheirForceAtTheGapThatTheyHaveOpened) {
    GluedBlock glued(0, 1e5, 1e5);
    Simulation sim(glued.scene);
    ASSERT_EQ(sim.run(glued.stage).status, dda::RunStatus::completed);
    double stiffness = 0;
    for (dda::Contact& contact : sim.state.contacts.contacts) {
        if (contact.state == dda::ContactState::open) continue;
        contact.normal_force = -1000;
        contact.gap = 2e-3;
        stiffness = dda::normal_spring(glued.scene.model, contact).stiffness;
    }
    dda::relax_held_bonds(glued.scene.model, sim.state);
    for (const dda::Contact& contact : sim.state.contacts.contacts) {
        if (contact.state == dda::ContactState::open) continue;
        EXPECT_NEAR(stiffness * (contact.stress_free_gap - contact.gap), -1000, 1e-9 * stiffness);
    }
}

}  // namespace
}  // namespace rockslope::bonds_test
