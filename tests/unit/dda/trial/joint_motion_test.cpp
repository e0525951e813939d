#include "dda/trial/joint_motion.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rockslope::joint_motion_test {
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

/// The combined motion of two contacts of 0.5 m with springs of 1e8 N/m, for given normal forces.
dda::SegmentMotion moved(const std::vector<Contact>& contacts, double first, double second) {
    const std::vector<dda::ContactIndex> members = {0, 1};
    const std::array<double, 2> normal = {first, second};
    return dda::segment_motion(members, contacts, [&](dda::ContactIndex k) {
        ContactMotion motion;
        motion.displacement = k == 0 ? 1e-3 : 3e-3;
        motion.normal_force = normal[k];
        motion.length = 0.5;
        motion.stiffness = 1e8;
        motion.shear_force = 10;
        return motion;
    });
}

// The strength of a rough joint depends on its normal force over its length. The normal force is continuous
// where a contact opens, so all other inputs of the law must be continuous there, too.
TEST(SegmentMotion, IsContinuousWhereAContactOpens) {
    for (const ContactState second : {ContactState::open, ContactState::locked}) {
        const std::vector<Contact> contacts = {contact(ContactState::sliding, 5), contact(second, 0)};
        const auto closed = moved(contacts, 7, 1e-9), opened = moved(contacts, 7, -1e-9);
        EXPECT_NEAR(closed.motion.normal_force, opened.motion.normal_force, 2e-9);
        EXPECT_EQ(closed.motion.length, opened.motion.length);
        EXPECT_EQ(closed.motion.stiffness, opened.motion.stiffness);
        EXPECT_EQ(closed.motion.displacement, opened.motion.displacement);
        EXPECT_EQ(closed.motion.shear_force, opened.motion.shear_force);
        EXPECT_EQ(closed.motion.length, second == ContactState::open ? 0.5 : 1.0);
    }
}

TEST(SegmentMotion, CombinesAllContactsIfAllWereOpen) {
    const std::vector<Contact> contacts = {contact(ContactState::open, 0), contact(ContactState::open, 0)};
    const auto combined = moved(contacts, 3, 4);
    EXPECT_EQ(combined.motion.normal_force, 7);
    EXPECT_EQ(combined.motion.length, 1);
    EXPECT_EQ(combined.motion.displacement, 2e-3);
    EXPECT_EQ(moved(contacts, 3, -4).motion.normal_force, 3) << "tension of an open contact does not count";
    EXPECT_EQ(moved(contacts, -3, 0).motion.normal_force, 0) << "an open segment moves without a force";
    EXPECT_EQ(moved(contacts, -3, 0).motion.displacement, 2e-3);
}

TEST(SegmentMotion, TakesTheHistoryOfTheContactWithTheLargestForce) {
    const std::vector<Contact> contacts = {contact(ContactState::locked, 1),
                                           contact(ContactState::locked, 5)};
    EXPECT_EQ(moved(contacts, 3, 4).history, &contacts[1].history);
}

}  // namespace
}  // namespace rockslope::joint_motion_test
