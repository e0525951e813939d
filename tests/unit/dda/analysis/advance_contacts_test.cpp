#include "dda/analysis/advance_contacts.hpp"

#include <gtest/gtest.h>

#include "support/resting_block.hpp"

namespace rockslope::advance_contacts_test {
namespace {

using namespace scene;
using dda::ContactState;

/// A block on a floor, moved up by 1 mm and to the right by 2 mm, and what the step found at its contacts.
struct AdvancedBlock {
    FirstStep step;
    std::vector<dda::EvaluatedContact> evaluated{2};
    std::vector<dda::Contact> contacts;

    explicit AdvancedBlock(const dda::JointLaw& law) : step(resting_block(law).model) {
        for (dda::EvaluatedContact& e : evaluated) {
            e.state = ContactState::sliding;
            e.normal_force = 3e4;
            e.normal_spring_force = 2e4;
            e.shear_force = 1e4;
            e.stress_free_gap = 1e-4;
            e.displacement = e.slip = -2e-3;
        }
    }
    void advance() {
        contacts = step.set.contacts;
        auto vertices = step.state.blocks.vertices;
        for (int corner = 4; corner < 8; ++corner) vertices[corner] += Vec2(2e-3, 1e-3);
        dda::advance_contacts(step.model,
                              {step.found.segments, vertices, evaluated, step.springs, dda::StepTime(0.01)},
                              step.pool, contacts);
    }
};

TEST(AdvanceContacts, MovesThemToTheEndOfTheStep) {
    AdvancedBlock block(Scene::mohr_coulomb(30));
    for (dda::Contact& contact : block.step.found.set.contacts) contact.slip = 5e-3;
    block.advance();
    ASSERT_EQ(block.contacts.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        const dda::Contact& contact = block.contacts[k];
        EXPECT_NEAR((contact.point - block.step.set.contacts[k].point - Vec2(2e-3, 1e-3)).norm(), 0, 1e-15);
        EXPECT_NEAR(contact.gap, 1e-3, 1e-15);
        EXPECT_NEAR((contact.normal - Vec2(0, 1)).norm(), 0, 1e-15);
        EXPECT_EQ(contact.state, ContactState::sliding);
        EXPECT_EQ(contact.normal_force, 3e4);
        EXPECT_EQ(contact.normal_spring_force, 2e4);
        EXPECT_EQ(contact.shear_force, 1e4);
        EXPECT_EQ(contact.stress_free_gap, 1e-4);
        EXPECT_NEAR(contact.slip, 5e-3 - 2e-3, 1e-18) << "accumulates";
    }
}

TEST(AdvanceContacts, AnOpenContactHasNoShearForce) {
    AdvancedBlock block(Scene::mohr_coulomb(30));
    for (dda::EvaluatedContact& e : block.evaluated) e.state = ContactState::open;
    block.advance();
    for (const dda::Contact& contact : block.contacts) {
        EXPECT_EQ(contact.state, ContactState::open);
        EXPECT_EQ(contact.shear_force, 0);
    }
}

const dda::JointLaw bonded{dda::MohrCoulomb{radians(30), 1e5, 5e4, radians(20), 1e4}};

// A joint that slips, or whose bond breaks, has its residual strength from then on, and bears no tension.
TEST(AdvanceContacts, BreaksTheBondOfAJointThatSlipsOrOpens) {
    for (const bool slips : {true, false}) {
        AdvancedBlock block(bonded);
        for (dda::EvaluatedContact& e : block.evaluated) {
            e.slip = slips ? -1e-3 : 0;
            e.bond_broken = !slips;
        }
        block.advance();
        for (const dda::Contact& contact : block.contacts) {
            EXPECT_FALSE(contact.bonded);
            EXPECT_NEAR(strength(bonded, contact.history, 0, 1).forward, 1e4, 1e-9);
        }
    }
}

TEST(AdvanceContacts, KeepsTheBondOfALockedJoint) {
    AdvancedBlock block(bonded);
    for (dda::EvaluatedContact& e : block.evaluated) {
        e.state = ContactState::locked;
        e.slip = 0;
    }
    block.advance();
    for (const dda::Contact& contact : block.contacts) {
        EXPECT_TRUE(contact.bonded);
        EXPECT_NEAR(strength(bonded, contact.history, 0, 1).forward, 1e5, 1e-9);
    }
}

// Both ends move by 2 mm on asperities of 10 degrees, of which the springs take N tan 40 / k. They have one
// history, whose dilation is tan 10 times the slip. The contacts dilate by what the step was solved with,
// from which the gap of 1 mm is counted; the rest is left to the next step.
TEST(AdvanceContacts, GivesASegmentOneHistoryAndItsDilation) {
    const dda::JointLaw law = dda::Plesha{{radians(30), radians(10), 0}};
    AdvancedBlock block(law);
    for (dda::EvaluatedContact& e : block.evaluated) e.dilation_increment = 1e-4;
    block.advance();
    const double slip = 2e-3 - 3e4 * std::tan(radians(40)) / RestingContacts::spring;
    const double dilation = slip * std::tan(radians(10));
    for (const dda::Contact& contact : block.contacts) {
        EXPECT_NEAR(dda::dilation(law, *contact.history), dilation, 1e-12);
        EXPECT_EQ(contact.dilation, 1e-4);
        EXPECT_NEAR(contact.gap, 1e-3 - 1e-4, 1e-12);
        EXPECT_EQ(contact.history, block.contacts[0].history);
    }
}

// A law that weakens with the speed needs the time that the slip took: 2 mm in 10 ms are 0.2 m/s.
TEST(AdvanceContacts, TellsTheLawTheDurationOfTheStep) {
    const dda::VelocityWeakening law{radians(35), radians(20), 0.1, 0};
    AdvancedBlock block(law);
    block.advance();
    const dda::JointHistory expected = advance(law, dda::fresh_history(law, true),
                                               {-2e-3, -2e-3, 3e4, 0.5, false, 0, 1e9, dda::StepTime(0.01)});
    EXPECT_LT(strength(law, expected, 1e4, 0.5).forward, 0.9 * 1e4 * std::tan(radians(35))) << "has weakened";
    for (const dda::Contact& contact : block.contacts)
        EXPECT_NEAR(strength(law, contact.history, 1e4, 0.5).forward,
                    strength(law, expected, 1e4, 0.5).forward, 1e-9);
}

}  // namespace
}  // namespace rockslope::advance_contacts_test
