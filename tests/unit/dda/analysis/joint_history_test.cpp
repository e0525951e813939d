// The two contacts at the ends of a rough joint share one spring and have one history.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "dda/contact/contact_stiffness.hpp"
#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::joint_history_test {
namespace {

using namespace scene;

/// A block of 1 m on a rough floor, fixed along x, under an eccentric vertical force of 1 MN per metre.
/// @param eccentricity m
Simulation eccentric_load(double eccentricity) {
    Scene s;
    s.model.gravity.setZero();
    s.model.joint_materials[0].law = joint_tests::granite();
    s.model.block_materials[0].poissons_ratio = 0;
    s.box({-1, -1}, 3, 1, dda::Motion::prescribed, 0, "floor");
    const int block = s.box({0, 0}, 1, 1);
    for (const auto& [x, fraction] : {std::pair{0., .5 - eccentricity}, {1., .5 + eccentricity}}) {
        s.model.fixed_points.push_back({s.material_point(block, {x, 0}), true, false});
        s.model.loads.push_back(dda::PointLoad{s.material_point(block, {x, 1}), {0, -1e6 * fraction}, {}});
    }
    return Simulation(s);
}

// Eqs. (58) and (81): the shear stiffness is the strength of the whole joint over the peak displacement. Each
// end has the part of its normal force: 0.5 and, with the load 0.2 m off the middle of 1 m, 0.3 and 0.7.
TEST(JointHistory, TheEndsShareTheShearStiffnessByNormalForce) {
    const double joint_stiffness =
        joint_tests::granite_strength().shear_strength(1e6, 1, 1) / joint_tests::granite_peak;
    for (const double eccentricity : {0., .2}) {
        Simulation sim = eccentric_load(eccentricity);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        ASSERT_EQ(sim.state.contacts.contacts.size(), 2U);
        std::vector<double> shares;
        for (const dda::Contact& contact : sim.state.contacts.contacts)
            shares.push_back(dda::shear_stiffness(sim.model, contact) / joint_stiffness);
        // The tolerance allows for the strain of the block's bottom, about 1e-4.
        EXPECT_NEAR(std::min(shares[0], shares[1]), 0.5 - eccentricity, 1e-3);
        EXPECT_NEAR(std::max(shares[0], shares[1]), 0.5 + eccentricity, 1e-3);
    }
}

TEST(JointHistory, EndsUnderUnequalLoadsHaveTheSameHistory) {
    Simulation sim = eccentric_load(.2);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    sim.velocity(0)[0] = .02;
    dda::Stage stage;
    stage.name = "shear";
    stage.duration = .25;
    stage.dynamic_coefficient = 0;
    stage.control.step = 1e-3;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    const auto& contacts = sim.state.contacts.contacts;
    ASSERT_EQ(contacts.size(), 2U);
    EXPECT_GT(std::abs(contacts[0].normal_force - contacts[1].normal_force), 1e5);
    EXPECT_GT(std::abs(contacts[0].slip), 2 * joint_tests::granite_peak);
    EXPECT_EQ(contacts[0].history, contacts[1].history);
    EXPECT_EQ(contacts[0].dilation, contacts[1].dilation);
}

// On free ground a contact has the joint of the block's face that lies there, as long as it lasts, with a
// history of that joint's law.
TEST(JointHistory, OfABlockThatRollsOnFreeGroundIsOfTheJointOfEachContact) {
    Scene s;
    s.friction(40);
    s.model.joint_materials.push_back({"rough", joint_tests::granite(), 0, 0});
    s.box({-1, -1}, 30, 1, dda::Motion::fixed);
    const int block = s.box({0, .001}, 1, 1);
    int faces = 0;
    for (const dda::CornerIndex corner : s.model.topology.corners_of(block))
        s.model.topology.joint_material[dda::edge_from(corner)] = faces++ % 2;
    s.model.initial_velocity = {Vec6::Zero(), (Vec6() << 4, 0, -8, 0, 0, 0).finished()};
    Simulation sim(s);
    ASSERT_EQ(sim.shake(1, .002).status, dda::RunStatus::completed);
    EXPECT_LT(sim.state.blocks.rotation[1], -radians(170)) << "on its other faces";
}

}  // namespace
}  // namespace rockslope::joint_history_test
