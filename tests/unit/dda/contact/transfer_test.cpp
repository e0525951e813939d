#include "dda/contact/transfer.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::transfer_test {
namespace {

using namespace scene;
using dda::Contact;
using dda::ContactState;

Contact contact(int corner_block, int edge_block, int corner, int edge, const Vec2& point,
                const Vec2& normal) {
    Contact c;
    c.corner = corner;
    c.edge = edge;
    c.corner_block = corner_block;
    c.edge_block = edge_block;
    c.point = point;
    c.normal = normal;
    c.tangent = dda::perpendicular(normal);
    c.length = .5;
    return c;
}

Contact loaded(Contact c) {
    c.state = ContactState::sliding;
    c.normal_force = c.normal_spring_force = 100;
    c.shear_force = -30;
    c.slip = .25;
    c.history = dda::JointHistory(dda::MohrCoulomb::History{true});
    return c;
}

class Transfer : public testing::Test {
  protected:
    Contact moved_to(Contact now, double search_radius = .1, bool first_step = false) {
        std::vector<Contact> contacts = {now};
        dda::transfer_contacts(s.model, std::vector{old}, search_radius, first_step, contacts, ThreadPool(1));
        return contacts[0];
    }
    static void expect_carried(const Contact& c) {
        EXPECT_EQ(c.state, ContactState::sliding);
        EXPECT_EQ(c.normal_force, 100);
        EXPECT_EQ(c.shear_force, -30);
        EXPECT_EQ(c.slip, .25);
    }
    static void expect_fresh(const Contact& c) {
        EXPECT_EQ(c.state, ContactState::open);
        EXPECT_EQ(c.shear_force, 0);
        EXPECT_EQ(c.slip, 0);
    }

    Scene s;
    const Vec2 up{0, 1};
    /// Corner 4 of block 1 on edge 2 of block 0.
    Contact old = loaded(contact(1, 0, 4, 2, {0, 0}, up));
};

// On free ground detection takes the joint of the face that lies there now; the history is of the one before.
TEST_F(Transfer, AContactKeepsItsJointWithItsHistory) {
    Contact now = contact(1, 0, 4, 2, {0, 0}, up);
    now.joint_material = 1;
    const Contact carried = moved_to(now);
    expect_carried(carried);
    EXPECT_EQ(carried.joint_material, 0);
}

TEST_F(Transfer, TheSamePairKeepsItsState) {
    expect_carried(moved_to(contact(1, 0, 4, 2, {.05, 0}, up)));
}

TEST_F(Transfer, TheSamePairKeepsItsStateAtAnyDistance) {
    expect_carried(moved_to(contact(1, 0, 4, 2, {5, 0}, Vec2(1, 0))));
}

TEST_F(Transfer, SlidingOntoTheNextEdge) {
    expect_carried(moved_to(contact(1, 0, 4, 3, {.05, 0}, up)));
}

TEST_F(Transfer, CornerAndEdgeExchangeRoles) {
    const Contact now = moved_to(contact(0, 1, 3, 5, {.05, 0}, -up));
    expect_carried(now);
    // Positive shear pushes the corner's block along -tangent. Blocks and tangent are both exchanged, so the
    // force on block 1 is the same.
    EXPECT_EQ(old.shear_force * old.tangent, -now.shear_force * now.tangent);
}

TEST_F(Transfer, SlidingOntoANeighboursFace) {
    expect_carried(moved_to(contact(1, 2, 4, 9, {.05, 0}, up)));
}

TEST_F(Transfer, NotBeyondTheLargestDisplacement) {
    expect_fresh(moved_to(contact(1, 0, 4, 3, {.11, 0}, up)));
}

TEST_F(Transfer, NotFromALineInAnotherDirection) {
    expect_fresh(moved_to(contact(1, 0, 4, 3, {0, 0}, Vec2(1, 0))));
    expect_fresh(moved_to(contact(1, 0, 4, 3, {0, 0}, -up)));
    expect_fresh(moved_to(contact(0, 1, 3, 5, {0, 0}, up)));
    const double four_degrees = 4 * std::numbers::pi / 180;
    expect_fresh(moved_to(contact(1, 0, 4, 3, {0, 0}, {std::sin(four_degrees), std::cos(four_degrees)})));
}

TEST_F(Transfer, NotFromOtherBlocks) {
    expect_fresh(moved_to(contact(3, 2, 12, 9, {0, 0}, up)));
}

TEST_F(Transfer, NotFromAnotherJoint) {
    s.model.joint_materials.push_back(s.model.joint_materials[0]);
    Contact now = contact(1, 0, 4, 3, {0, 0}, up);
    now.joint_material = 1;
    expect_fresh(moved_to(now));
}

TEST_F(Transfer, AContactMatchesOnceAndTheNearest) {
    std::vector<Contact> contacts = {contact(1, 0, 4, 3, {.05, 0}, up), contact(1, 0, 5, 3, {.01, 0}, up)};
    dda::transfer_contacts(s.model, std::vector{old}, .1, false, contacts, ThreadPool(1));
    EXPECT_EQ((contacts[0].state != ContactState::open) + (contacts[1].state != ContactState::open), 1);
}

// The corner slides onto a neighbour's face, and the end of the overlap that it leaves has a corner: one
// contact becomes two, and the force stays with the corner.
TEST_F(Transfer, ForceStaysWithTheCornerOnANeighboursFace) {
    std::vector<Contact> contacts = {contact(0, 1, 3, 5, {.01, 0}, -up), contact(1, 2, 4, 9, {.02, 0}, up)};
    dda::transfer_contacts(s.model, std::vector{old}, .1, false, contacts, ThreadPool(1));
    expect_fresh(contacts[0]);
    EXPECT_TRUE(std::get<dda::MohrCoulomb::History>(*contacts[0].history).broken) << "it is the same joint";
    expect_carried(contacts[1]);
}

TEST_F(Transfer, ForcePassesToAnExistingOpenContact) {
    const Contact next = contact(1, 2, 4, 9, {.02, 0}, up);
    std::vector<Contact> contacts = {next};
    dda::transfer_contacts(s.model, std::vector{old, next}, .1, false, contacts, ThreadPool(1));
    expect_carried(contacts[0]);
}

// The predecessor is between other blocks, so its history is not that of the existing contact.
TEST_F(Transfer, AnOpenPredecessorKeepsTheExistingHistory) {
    old.state = ContactState::open;
    const Contact next = contact(1, 2, 4, 9, {.02, 0}, up);
    std::vector<Contact> contacts = {next};
    dda::transfer_contacts(s.model, std::vector{old, next}, .1, false, contacts, ThreadPool(1));
    EXPECT_EQ(contacts[0].history, next.history);
    EXPECT_EQ(contacts[0].slip, 0);
    dda::transfer_contacts(s.model, std::vector{old}, .1, false, contacts, ThreadPool(1));
    EXPECT_EQ(contacts[0].history, old.history) << "a new contact inherits the history";
}

TEST_F(Transfer, TheForceStaysTheSameAtAnotherDepth) {
    old.gap = -2e-9;  // 100 N over 5e10 N/m
    Contact now = contact(1, 0, 4, 3, {.05, 0}, up);
    now.gap = -3e-9;
    EXPECT_NEAR(moved_to(now).stress_free_gap, -1e-9, 1e-20);
}

TEST_F(Transfer, NotToADeeperContact) {
    old.gap = -1e-6;
    Contact deeper = contact(1, 0, 4, 3, {.05, 0}, up);
    deeper.gap = -1.9e-6;
    expect_carried(moved_to(deeper));
    deeper.gap = -3e-6;
    expect_fresh(moved_to(deeper));
}

TEST_F(Transfer, InTheFirstStepFacesThatTouchAreIntactAndLocked) {
    s.model.joint_materials[0].law = Scene::mohr_coulomb(30, 1e5, 1e4);
    const auto fresh = [&](double gap, bool first_step) {
        std::vector<Contact> contacts = {contact(1, 0, 4, 2, {0, 0}, up)};
        contacts[0].gap = gap;
        dda::transfer_contacts(s.model, {}, .1, first_step, contacts, ThreadPool(1));
        return contacts[0];
    };
    for (const double gap : {0.0, 4e-7, -4e-7}) {
        EXPECT_EQ(fresh(gap, true).state, ContactState::locked);
        EXPECT_TRUE(fresh(gap, true).bonded);
        EXPECT_FALSE(std::get<dda::MohrCoulomb::History>(*fresh(gap, true).history).broken);
    }
    for (const Contact& c : {fresh(1e-3, true), fresh(0, false)}) {
        EXPECT_EQ(c.state, ContactState::open);
        EXPECT_FALSE(c.bonded);
        EXPECT_TRUE(std::get<dda::MohrCoulomb::History>(*c.history).broken);
    }
}

}  // namespace
}  // namespace rockslope::transfer_test
