#include "dda/analysis/shear_sharing.hpp"

#include <gtest/gtest.h>

#include "dda/contact/contact_stiffness.hpp"
#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::shear_sharing_test {
namespace {

using dda::Contact;

/// Two contacts of one rough joint segment of 1 m, with 0.3 m and 0.7 m.
struct TwoEnds {
    dda::Model model = scene::Scene().model;
    std::vector<Contact> contacts;

    TwoEnds(const dda::JointLaw& law, double first_normal, double second_normal) {
        model.joint_materials[0].law = law;
        model.shear_penalty = 1e9;
        for (const auto& [x, length, normal, shear] :
             {std::tuple{0.0, 0.3, first_normal, 500.0}, {1.0, 0.7, second_normal, 300.0}}) {
            Contact& contact = contacts.emplace_back();
            contact.joint_material = 0;
            contact.corner_block = 1;
            contact.edge_block = 0;
            contact.point = {x, 0};
            contact.normal = {0, 1};
            contact.tangent = {-1, 0};
            contact.length = length;
            contact.normal_force = normal;
            contact.shear_force = shear;
            contact.state = dda::ContactState::locked;
            contact.history = dda::fresh_history(law, true);
        }
    }
    void share() {
        const dda::JointSegments segments(model, contacts);
        dda::share_shear_force(model, segments, contacts);
    }
};

const dda::JointLaw rough = dda::Plesha{{0.5, 0.1, 0}};

// Eq. (81): one quarter and three quarters of the normal force, so also of the 800 N of shear force.
TEST(ShearSharing, IsInProportionToTheNormalForces) {
    TwoEnds ends(rough, 1000, 3000);
    ends.share();
    EXPECT_DOUBLE_EQ(ends.contacts[0].shear_force, 200);
    EXPECT_DOUBLE_EQ(ends.contacts[1].shear_force, 600);
    EXPECT_DOUBLE_EQ(ends.contacts[0].joint_share, 0.25);
    EXPECT_DOUBLE_EQ(ends.contacts[1].joint_share, 0.75);
}

// The springs that the model gives, 1e9 N/m for each contact, keep their sum.
TEST(ShearSharing, KeepsTheSumOfTheSprings) {
    TwoEnds ends(rough, 1000, 3000);
    ends.share();
    EXPECT_DOUBLE_EQ(dda::shear_stiffness(ends.model, ends.contacts[0]), 0.25 * 2e9);
    EXPECT_DOUBLE_EQ(dda::shear_stiffness(ends.model, ends.contacts[1]), 0.75 * 2e9);
}

TEST(ShearSharing, IsByLengthWithoutANormalForce) {
    TwoEnds ends(rough, 0, -10);
    ends.share();
    EXPECT_EQ(ends.contacts[0].shear_force, 500) << "the forces stay";
    EXPECT_EQ(ends.contacts[1].shear_force, 300);
    EXPECT_DOUBLE_EQ(ends.contacts[0].joint_share, 0.3);
    EXPECT_DOUBLE_EQ(ends.contacts[1].joint_share, 0.7);
}

TEST(ShearSharing, LeavesAnEndWithoutNormalForceASpring) {
    TwoEnds ends(rough, 0, 4000);
    ends.share();
    EXPECT_EQ(ends.contacts[0].shear_force, 0);
    EXPECT_DOUBLE_EQ(ends.contacts[1].shear_force, 800);
    EXPECT_DOUBLE_EQ(ends.contacts[0].joint_share, 1e-3);
    EXPECT_GT(dda::shear_stiffness(ends.model, ends.contacts[0]), 0);
}

TEST(ShearSharing, LeavesAugmentedContactsTheirForces) {
    TwoEnds ends(rough, 1000, 3000);
    ends.model.penetration_tolerance = 1e-9;
    ends.share();
    EXPECT_EQ(ends.contacts[0].shear_force, 500);
    EXPECT_DOUBLE_EQ(ends.contacts[0].joint_share, 0.3);
}

// The contacts of a smooth joint have histories, forces and springs of their own.
TEST(ShearSharing, DoesNotConcernLawsOfSingleContacts) {
    TwoEnds ends(scene::Scene::mohr_coulomb(30), 1000, 3000);
    ends.share();
    EXPECT_EQ(ends.contacts[0].shear_force, 500);
    EXPECT_EQ(ends.contacts[0].joint_share, 1);
    EXPECT_EQ(dda::shear_stiffness(ends.model, ends.contacts[0]), 1e9);
}

}  // namespace
}  // namespace rockslope::shear_sharing_test
