#include "dda/analysis/ledger.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/resting_block.hpp"

namespace rockslope::ledger_test {
namespace {

using namespace scene;
using dda::ContactState;

constexpr double mass = 2500;   // kg, of a block of 1 m x 1 m
constexpr double young = 10e9;  // Pa
constexpr double poisson = 0.25;
constexpr double spring = RestingContacts::spring;
const ThreadPool one_thread;

dda::Energy stored_in(const dda::Model& model, const dda::State& state) {
    dda::Energy energy;
    const dda::RowMap rows(model.motion);
    dda::Ledger(model, rows, one_thread).update_stored_energy(state, energy);
    return energy;
}

// A unit square has the second moment 1/12: rotating at w it has m w^2 / 12 and moving at v it has m v^2 / 2.
TEST(Ledger, StoresKineticEnergyOfFreeBlocks) {
    const Scene s = resting_block(Scene::mohr_coulomb(30));
    dda::State state = dda::initial_state(s.model);
    state.blocks.velocity[0][0] = 100;  // fixed: the velocity of a block without unknowns does not count
    state.blocks.velocity[1] << 3, 4, 2, 0, 0, 0;
    EXPECT_NEAR(stored_in(s.model, state).kinetic, mass * 25 / 2 + mass / 6 * 4 / 2, 1e-9 * mass);
}

// In plane strain a uniaxial stress s stores s^2 (1 - nu^2) / 2E, a shear stress t stores t^2 (1 + nu) / E.
TEST(Ledger, StoresStrainEnergy) {
    const Scene s = resting_block(Scene::mohr_coulomb(30));
    dda::State state = dda::initial_state(s.model);
    state.blocks.stress[0] << 1e7, 0, 0;
    state.blocks.stress[1] << 1e6, 0, 0;
    EXPECT_NEAR(stored_in(s.model, state).strain, 1e12 * (1 - poisson * poisson) / (2 * young), 1e-9);
    state.blocks.stress[1] << 0, 0, 1e6;
    EXPECT_NEAR(stored_in(s.model, state).strain, 1e12 * (1 + poisson) / young, 1e-9);
}

TEST(Ledger, StoresPotentialEnergyFromTheStartOfTheRun) {
    const Scene s = resting_block(Scene::mohr_coulomb(30));
    dda::State state = dda::initial_state(s.model);
    EXPECT_EQ(stored_in(s.model, state).gravity, 0);
    EXPECT_FALSE(std::signbit(stored_in(s.model, state).gravity)) << "tables have 0, not -0";
    state.blocks.moments[1].centroid += Vec2(7, 2);
    EXPECT_NEAR(stored_in(s.model, state).gravity, mass * g * 2, 1e-9 * mass);
}

// F^2 / 2k in each spring; an open contact and an augmented one store nothing.
TEST(Ledger, StoresTheEnergyOfContactSprings) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    dda::State state = dda::initial_state(s.model);
    for (const auto contact_state : {ContactState::locked, ContactState::sliding, ContactState::open}) {
        dda::Contact& contact = state.contacts.contacts.emplace_back();
        contact.state = contact_state;
        contact.joint_material = 0;
        contact.normal_force = contact.normal_spring_force = 3e4;
        contact.shear_force = -1e4;
    }
    const double each = (9e8 + 1e8) / (2 * spring);
    EXPECT_NEAR(stored_in(s.model, state).contact, 2 * each, 1e-9);
    s.model.penetration_tolerance = 1e-9;
    EXPECT_EQ(stored_in(s.model, state).contact, 0);
}

// One contact bears half of its force on a spring as stiff, another one that continues none bears the whole.
TEST(Ledger, RecordsWhatSpringsGainOrLoseWhileTheyAreReplaced) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    dda::PerContact<dda::Contact> before(1), after(2);
    for (dda::Contact* contact :
         {&before[dda::ContactIndex(0)], &after[dda::ContactIndex(0)], &after[dda::ContactIndex(1)]}) {
        contact->state = ContactState::locked;
        contact->joint_material = 0;
        contact->corner_block = 1;
        contact->edge_block = 0;
        contact->corner = 4;
        contact->edge = 2;
        contact->normal_force = contact->normal_spring_force = 3e4;
    }
    after[dda::ContactIndex(0)].normal_force = after[dda::ContactIndex(0)].normal_spring_force = 1.5e4;
    after[dda::ContactIndex(1)].corner = 5;
    const double whole = 9e8 / (2 * spring);
    const dda::RowMap rows(s.model.motion);
    const dda::Ledger ledger(s.model, rows, one_thread);
    dda::Energy energy;
    energy.contact = whole;
    ledger.record_transfer(before, after, {}, 2.5, energy);
    EXPECT_NEAR(energy.released, -whole / 4, 1e-9);
    EXPECT_NEAR(energy.largest_spring_gain.amount, whole, 1e-9);
    EXPECT_EQ(energy.largest_spring_gain.time, 2.5);
    EXPECT_EQ(energy.largest_spring_gain.corner_block, dda::BlockIndex(1));
    energy.contact = whole * 5 / 4;
    ledger.record_transfer(after, before, {}, 3, energy);
    EXPECT_NEAR(energy.released, 0, 1e-9);
    EXPECT_EQ(energy.largest_spring_gain.time, 2.5) << "that lost energy";
}

/// The first step of a block on a rough joint whose two contacts are pressed by 10 kN each and share 8 kN of
/// shear force.
struct OnARoughJoint {
    FirstStep step;

    explicit OnARoughJoint(double first_share)
        : step(resting_block(dda::Plesha{radians(30), radians(5), 1e-6}).model) {
        double share = first_share;
        for (dda::Contact& contact : step.found.set.contacts) {
            contact.state = ContactState::locked;
            contact.normal_force = contact.normal_spring_force = 1e4;
            contact.shear_force = 8e3 * std::exchange(share, 1 - first_share);
        }
    }
    dda::State state() const {
        dda::State state = dda::initial_state(step.model);
        state.contacts.contacts = step.set.contacts;
        return state;
    }
};

// Eq. (81): the joint's spring of 2 GN/m bears 8 kN, however its two contacts share that.
TEST(Ledger, StoresTheEnergyOfOneSpringForEachJointSegment) {
    const double stored = 2 * 1e8 / (2 * spring) + 64e6 / (2 * 2 * spring);
    for (const double share : {0.5, 0.75, 1.0}) {
        const OnARoughJoint block(share);
        ASSERT_EQ(block.step.found.segments.count(), 1u);
        EXPECT_NEAR(stored_in(block.step.model, block.state()).contact, stored, 1e-12) << share;
    }
}

// Contacts that share the force of their joint anew neither gain nor lose energy.
TEST(Ledger, ReleasesNothingWhereContactsShareTheForceOfTheirJointAnew) {
    const OnARoughJoint before(0.5);
    const OnARoughJoint after(0.9);
    dda::Energy energy = stored_in(before.step.model, before.state());
    dda::Ledger(before.step.model, before.step.rows, one_thread)
        .record_transfer(before.step.set.contacts, after.step.set.contacts, after.step.found.segments, 1,
                         energy);
    EXPECT_NEAR(energy.released, 0, 1e-15);
}

// A fixed point that has moved by 1 mm along the axis that it holds; a bolt of EA = 2e7 N and 2 m under 4 kN.
TEST(Ledger, StoresTheEnergyOfFixedPointsAndBolts) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.fixed_point_penalty = 1e9;
    s.model.fixed_points.push_back({s.material_point(1, {1, 1}), true, false});
    s.model.bolts.push_back(
        {"bolt", s.material_point(0, {0.5, -1}), s.material_point(1, {0.5, 1}), 2e7, 4e3, 0});
    dda::State state = dda::initial_state(s.model);
    state.blocks.points[0] += Vec2(1e-3, 5e-3);
    EXPECT_NEAR(stored_in(s.model, state).constraint, 1e9 * 1e-6 / 2 + 4e3 * 4e3 / (2 * 1e7), 1e-9);
}

/// One step of a resting block that moves by `along` the tangent and `into` the floor.
struct RecordedStep {
    FirstStep step;
    dda::OpenCloseResult result;
    dda::Energy energy;
    dda::Newmark newmark{0.5, 1, 0.01};

    RecordedStep(const Scene& s, double along, double into) : step(s.model) {
        result.displacement = {RestingContacts::displacement(along, into)};
        result.contacts.resize(step.set.contacts.size());
        result.bolt_force = step.state.bolt_force;
        for (dda::EvaluatedContact& e : result.contacts) e.displacement = along;
    }
    dda::StepWork work() const {
        return {step.state.blocks,
                step.mid,
                step.set.contacts,
                step.found.segments,
                step.springs,
                {},
                step.bolts,
                step.state.bolt_force,
                {},
                result,
                newmark,
                0,
                1,
                2.5,
                {}};
    }
    dda::Ledger ledger() const { return {step.model, step.rows, one_thread}; }
    void record_contacts() { ledger().record_contacts(work(), step.set.contacts, energy); }
};

// The end-of-step force N of a spring that is closed by c does the work N c and stores N c / 2: half is lost,
// Eq. (42). The shear force S = k u / 2 at its bound slips by u / 2: S u / 2 is friction; the spring of S
// stores S u / 4 and loses as much.
TEST(Ledger, SplitsTheWorkOfASlidingContact) {
    RecordedStep step(resting_block(Scene::mohr_coulomb(30)), 2e-5, 3e-5);
    for (dda::EvaluatedContact& e : step.result.contacts) {
        e.state = ContactState::sliding;
        e.normal_force = e.normal_spring_force = 3e4;
        e.shear_force = 1e4;
        e.slip = 1e-5;
    }
    step.record_contacts();
    EXPECT_NEAR(step.energy.friction_loss, 2 * 1e4 * 1e-5, 1e-12);
    EXPECT_NEAR(step.energy.numerical_loss, 2 * (3e4 * 3e-5 / 2 + 1e4 * 1e-5 / 2), 1e-12);
    EXPECT_EQ(step.energy.released, 0);
    EXPECT_EQ(step.energy.friction_returned, 0);
    EXPECT_EQ(step.energy.external_work, 0);
}

// Slip along the shear force's direction takes energy; the other way would give it back, and is told.
TEST(Ledger, TellsOfFrictionThatDrives) {
    RecordedStep step(resting_block(Scene::mohr_coulomb(30)), 2e-5, 3e-5);
    for (dda::EvaluatedContact& e : step.result.contacts) {
        e.state = ContactState::sliding;
        e.normal_force = e.normal_spring_force = 3e4;
        e.shear_force = -1e4;
        e.slip = 1e-5;
    }
    step.record_contacts();
    EXPECT_NEAR(step.energy.friction_loss, -2 * 1e4 * 1e-5, 1e-12);
    EXPECT_NEAR(step.energy.friction_returned, 2 * 1e4 * 1e-5, 1e-12);
    EXPECT_NEAR(step.energy.largest_gain.amount, 1e4 * 1e-5, 1e-12) << "one of two contacts";
    EXPECT_EQ(step.energy.largest_gain.time, 2.5);
    EXPECT_EQ(step.energy.largest_gain.corner_block, step.step.set.contacts[0].corner_block);
}

/// A step at whose start both contacts are locked under 3e4 N and 1e4 N.
struct OpeningStep : RecordedStep {
    explicit OpeningStep(bool bond_breaks) : RecordedStep(resting_block(Scene::mohr_coulomb(30)), 0, -1e-3) {
        for (dda::Contact& contact : step.found.set.contacts) {
            contact.state = ContactState::locked;
            contact.normal_force = contact.normal_spring_force = 3e4;
            contact.shear_force = 1e4;
        }
        for (dda::EvaluatedContact& e : result.contacts) e.bond_broken = bond_breaks;
    }
};

// Where a contact opens its shear spring is released; its normal spring did nothing in the step, which is
// the error of the integration. Where a bond breaks all is released.
TEST(Ledger, ReleasesTheSpringsOfAnOpeningContact) {
    const double normal = 2 * 9e8 / (2 * spring), shear = 2 * 1e8 / (2 * spring);
    OpeningStep opened(false);
    opened.record_contacts();
    EXPECT_NEAR(opened.energy.released, shear, 1e-12);
    EXPECT_NEAR(opened.energy.numerical_loss, normal, 1e-12);
    OpeningStep broken(true);
    broken.record_contacts();
    EXPECT_NEAR(broken.energy.released, normal + shear, 1e-12);
    EXPECT_EQ(broken.energy.numerical_loss, 0);
}

// A joint that dilates by 4 um against 3e4 N does the work N delta against the normal forces. With constant
// forces at both ends it is friction that gets less by it.
TEST(Ledger, ChargesDilationToFriction) {
    Scene s = resting_block(dda::Plesha{{radians(30), radians(10), 0}});
    RecordedStep step(s, 2e-5, 0);
    for (dda::Contact& contact : step.step.found.set.contacts) {
        contact.state = ContactState::sliding;
        contact.normal_force = contact.normal_spring_force = 3e4;
        contact.shear_force = 1e4;
    }
    for (dda::EvaluatedContact& e : step.result.contacts) {
        e.state = ContactState::sliding;
        e.normal_force = e.normal_spring_force = 3e4;
        e.shear_force = 1e4;
        e.slip = 2e-5;
        e.dilation_increment = 4e-6;
    }
    step.record_contacts();
    EXPECT_NEAR(step.energy.friction_loss, 2 * (1e4 * 2e-5 - 3e4 * 4e-6), 1e-12);
    EXPECT_NEAR(step.energy.numerical_loss, 2 * 3e4 * 4e-6, 1e-12) << "the normal springs' own closure";
}

// The floor moves by 1 mm along the tangent: it does the work S times 1 mm on the springs.
TEST(Ledger, CountsTheWorkOfPrescribedBlocks) {
    RecordedStep step(resting_block(Scene::mohr_coulomb(30)), 0, 0);
    for (dda::ContactSprings& s : step.step.springs) s.shear.prescribed = 1e-3;
    for (dda::EvaluatedContact& e : step.result.contacts) {
        e.state = ContactState::locked;
        e.normal_force = e.normal_spring_force = 3e4;
        e.shear_force = 1e4;
    }
    step.record_contacts();
    EXPECT_NEAR(step.energy.external_work, 2 * 1e4 * 1e-3, 1e-12);
}

// Eq. (42): d^T M a1 less the change of kinetic energy. From rest d = a1 dt^2 / 2 and v1 = a1 dt: no loss. A
// mass damping c takes c v1 m d, a velocity factor f takes (1 - f^2) m v1^2 / 2, and the weight's work is not
// external.
TEST(Ledger, RecordsInertiaAndDamping) {
    RecordedStep step(resting_block(Scene::mohr_coulomb(30)), 0, 5e-4);
    const double speed = 2 * 5e-4 / 0.01;
    const Scene loaded = [] {
        Scene s = resting_block(Scene::mohr_coulomb(30));
        s.model.loads.push_back(dda::PointLoad{s.material_point(1, {0.5, 0.5}), {0, -2e3}, {}});
        return s;
    }();
    step.ledger().record_blocks(step.work(), step.energy);
    EXPECT_NEAR(step.energy.numerical_loss, 0, 1e-9);
    EXPECT_EQ(step.energy.damping_loss, 0);
    EXPECT_EQ(step.energy.external_work, 0);

    RecordedStep damped(loaded, 0, 5e-4);
    dda::StepWork work = damped.work();
    work.mass_damping = 3;
    work.velocity_factor = 0.5;
    damped.ledger().record_blocks(work, damped.energy);
    EXPECT_NEAR(damped.energy.damping_loss, 3 * speed * mass * 5e-4 + 0.75 * mass * speed * speed / 2, 1e-9);
    EXPECT_NEAR(damped.energy.external_work, 2e3 * 5e-4, 1e-9);
}

// A bolt of k = 1e7 N/m that stretches by 1 mm from 1 kN yields at 5 kN: its plastic part is 0.6 mm.
TEST(Ledger, ChargesYieldingToFriction) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.bolts.push_back(
        {"bolt", s.material_point(0, {0.5, -1}), s.material_point(1, {0.5, 1}), 2e7, 1e3, 5e3});
    RecordedStep step(s, 0, -1e-3);
    step.result.bolt_force = {5e3};
    step.ledger().record_constraints(step.work(), step.energy);
    EXPECT_NEAR(step.energy.friction_loss, 5e3 * 6e-4, 1e-9);
    const double stored = (5e3 * 5e3 - 1e3 * 1e3) / (2 * 1e7);
    EXPECT_NEAR(step.energy.numerical_loss, 5e3 * 1e-3 - 5e3 * 6e-4 - stored, 1e-9);
}

// A fixed point of 1e9 N/m that moves by 0.5 mm loses k d^2 / 2 by the end-of-step force.
TEST(Ledger, RecordsTheLossOfFixedPoints) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.fixed_point_penalty = 1e9;
    s.model.fixed_points.push_back({s.material_point(1, {0.5, 0.5}), false, true});
    RecordedStep step(s, 7e-4, 5e-4);
    step.ledger().record_constraints(step.work(), step.energy);
    EXPECT_NEAR(step.energy.numerical_loss, 1e9 * 25e-8 / 2, 1e-9);
}

// A shear spring that becomes half as stiff under 1e4 N: what it stored at most it cannot hold.
TEST(Ledger, ReleasesTheDifferenceOfSpringsThatChange) {
    RecordedStep step(resting_block(Scene::mohr_coulomb(30)), 0, 0);
    dda::PerContact<dda::Contact> after = step.step.set.contacts;
    for (dda::Contact& contact : after) {
        contact.state = ContactState::locked;
        contact.shear_force = 1e4;
        contact.spring_share = 0.5;
    }
    after[1].state = ContactState::open;
    step.ledger().record_spring_changes(step.work(), after, step.energy);
    EXPECT_NEAR(step.energy.released, 1e8 / (2 * spring) - 1e8 / spring, 1e-12);
}

}  // namespace
}  // namespace rockslope::ledger_test
