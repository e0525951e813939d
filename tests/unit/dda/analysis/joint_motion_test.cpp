#include "dda/analysis/joint_motion.hpp"

#include <gtest/gtest.h>

using namespace rockslope;

namespace {

using dda::Contact;
using dda::ContactMotion;
using dda::ContactState;

Contact contact(ContactState state, double normal_force) {
    Contact c;
    c.state = state;
    c.normal_force = normal_force;
    c.history = dda::JointHistory(dda::MohrCoulomb::History{normal_force > 1});
    return c;
}

/// The motion of both, each of 0.5 m with a spring of 1e8, under the normal forces of a trial.
std::optional<dda::SegmentMotion> moved(const std::vector<Contact>& contacts, double first, double second) {
    const std::vector<int> members = {0, 1};
    const double normal[] = {first, second};
    return dda::segment_motion(members, contacts, [&](int k) {
        ContactMotion motion;
        motion.displacement = k == 0 ? 1e-3 : 3e-3;
        motion.normal_force = normal[k];
        motion.length = 0.5;
        motion.stiffness = 1e8;
        motion.shear_force = 10;
        return motion;
    });
}

// The strength of a rough joint depends on its normal force over its length: where one contact opens or
// closes the force has no jump, and nothing else may have one.
TEST(SegmentMotion, NothingJumpsWhereAContactOpens) {
    for (const ContactState second : {ContactState::open, ContactState::locked}) {
        const std::vector<Contact> contacts = {contact(ContactState::sliding, 5), contact(second, 0)};
        const auto pressed = moved(contacts, 7, 1e-9), opened = moved(contacts, 7, -1e-9);
        ASSERT_TRUE(pressed && opened);
        EXPECT_NEAR(pressed->motion.normal_force, opened->motion.normal_force, 2e-9);
        EXPECT_EQ(pressed->motion.length, opened->motion.length);
        EXPECT_EQ(pressed->motion.stiffness, opened->motion.stiffness);
        EXPECT_EQ(pressed->motion.displacement, opened->motion.displacement);
        EXPECT_EQ(pressed->motion.shear_force, opened->motion.shear_force);
        EXPECT_EQ(pressed->motion.length, second == ContactState::open ? 0.5 : 1.0);
    }
}

TEST(SegmentMotion, AJointThatWasOpenIsAllOfItsContacts) {
    const std::vector<Contact> contacts = {contact(ContactState::open, 0), contact(ContactState::open, 0)};
    const auto whole = moved(contacts, 3, 4);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->motion.normal_force, 7);
    EXPECT_EQ(whole->motion.length, 1);
    EXPECT_EQ(whole->motion.displacement, 2e-3);
    EXPECT_EQ(moved(contacts, 3, -4)->motion.normal_force, 3) << "what is open bears nothing";
    EXPECT_FALSE(moved(contacts, -3, 0));
}

TEST(SegmentMotion, TheHistoryIsThatOfTheContactThatBoreMost) {
    const std::vector<Contact> contacts = {contact(ContactState::locked, 1),
                                           contact(ContactState::locked, 5)};
    EXPECT_EQ(moved(contacts, 3, 4)->history, &contacts[1].history);
}

}  // namespace
