#include "dda/monitor/measured_joint.hpp"

#include <gmock/gmock.h>

#include "dda/analysis/run.hpp"
#include "unit/dda/input/model_text.hpp"

namespace rockslope::dda::measured_joint_test {
namespace {

using testing::HasSubstr;

/// The block of two_block_mesh(), 2 m x 1 m, on its base with 45 deg of friction, and a measured joint below
/// it.
class MeasuredJointTest : public io_test::ModelTextTest {
  protected:
    MeasuredJointTest()
        : ModelTextTest(R"(blocks = "two.blocks"
[block_material.rock]
density = 2500
youngs_modulus = "10 GPa"
poissons_ratio = 0
[joint_material.bedding]
law = "mohr-coulomb"
friction_angle = "45 deg"
cohesion = 3000
[[measured_joint]]
name = "bed"
at = [1.5, 1]
[[stage]]
kind = "static"
)") {}
};

class Silent : public RunObserver {
    bool step_done(const Model&, const State&, const Stage&, const StepReport&) override { return true; }
};

TEST_F(MeasuredJointTest, ReportsStressesAndDisplacementsOfTheJoint) {
    const RunInput input = read(changed("", ""));
    ASSERT_EQ(input.model.measured_joints.size(), 1u);
    State state = initial_state(input.model);
    Silent nothing;
    ASSERT_EQ(run(input.model, input.stages, state, nothing).status, RunStatus::completed);
    const JointReading settled = read_joint(input.model, state, input.model.measured_joints[0]);
    const double weight = 2500 * 9.81;  // Pa, weight of 1 m of rock
    EXPECT_NEAR(settled.normal_stress, weight, 1e-5 * weight);
    EXPECT_NEAR(settled.shear_stress, 0, 1e-5 * weight);
    EXPECT_NEAR(settled.strength, weight + 3000, 1e-5 * weight);
    EXPECT_NEAR(settled.displacement, 0, 1e-12);
    EXPECT_EQ(settled.state, ContactState::locked);

    // Move the block 3 mm to the right and 2 mm up: both are positive.
    const dda::PointIndex upper = input.model.measured_joints[0].point;
    state.blocks.points[upper] += Vec2(-3e-3, -2e-3);
    const JointReading moved = read_joint(input.model, state, input.model.measured_joints[0]);
    EXPECT_NEAR(moved.displacement - settled.displacement, 3e-3, 1e-9);
    EXPECT_NEAR(moved.dilation - settled.dilation, 2e-3, 1e-9);
    for (Contact& contact : state.contacts.contacts) {
        contact.shear_force = -500;  // pushes the corner's block along the tangent
        contact.slip = -1e-3;
        contact.state = ContactState::sliding;
    }
    const JointReading sheared = read_joint(input.model, state, input.model.measured_joints[0]);
    EXPECT_NEAR(sheared.shear_stress, 500, 1e-6) << "two contacts over 2 m, against motion to the right";
    EXPECT_NEAR(sheared.slip, 1e-3, 1e-12);
    EXPECT_EQ(sheared.state, ContactState::sliding);
    for (Contact& contact : state.contacts.contacts) contact.state = ContactState::open;
    const JointReading open = read_joint(input.model, state, input.model.measured_joints[0]);
    EXPECT_EQ(open.state, ContactState::open);
    EXPECT_EQ(open.normal_stress, 0);
}

/// Half of the block's face of 2 m is beyond the end of its base. Its weight, over the other half, bears
/// there.
TEST_F(MeasuredJointTest, StressesOverTheBearingLengthAndOverTheWholeJoint) {
    blockgen::BlockMesh mesh;
    mesh.vertices = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 1}, {3, 1}, {3, 1.2}, {2, 2}, {1, 2}};
    mesh.block_materials = {"rock"};
    mesh.joint_materials = {"bedding"};
    mesh.joints = {{"set"}};
    const blockgen::EdgeMark face, bed{0, 0};
    mesh.begin_block(0, blockgen::BlockMotion::prescribed, "base");
    mesh.add_ring(std::vector<blockgen::VertexIndex>{0, 1, 2, 4, 3},
                  std::vector<blockgen::EdgeMark>{face, face, bed, bed, face});
    mesh.begin_block(0);
    mesh.add_ring(std::vector<blockgen::VertexIndex>{4, 2, 5, 6, 7, 8},
                  std::vector<blockgen::EdgeMark>{bed, face, face, face, face, face});
    blockgen::write_block_file(folder / "two.blocks", mesh);
    const RunInput input = read(changed("", ""));
    State state = initial_state(input.model);
    Silent nothing;
    ASSERT_EQ(run(input.model, input.stages, state, nothing).status, RunStatus::completed);
    const double weight = 2500 * 9.81 * 1.6;  // N/m
    const JointReading bed_reading = read_joint(input.model, state, input.model.measured_joints[0]);
    EXPECT_NEAR(joint_length(input.model, input.model.measured_joints[0]), 2, 1e-12);
    EXPECT_NEAR(bed_reading.normal_stress, weight / 1, 1e-3 * weight);
    EXPECT_NEAR(bed_reading.normal_stress_over_joint, weight / 2, 1e-3 * weight);
    EXPECT_NEAR(bed_reading.strength, weight + 3000, 1e-3 * weight) << "of the length that bears";
}

TEST_F(MeasuredJointTest, PointsOffAJointAreRefused) {
    const std::string at = "at = [1.5, 1]";
    EXPECT_THAT(error_with(at, "at = [1.5, 1.1]"),
                HasSubstr("no joint runs within 0.001 m of 'at' in [measured_joint"));
    EXPECT_THAT(error_with(at, "at = [0.5, 1]"), HasSubstr("no joint runs within"));
    EXPECT_THAT(error_with(at, "at = [1.5, 1.1]\ntolerance = \"0 mm\""), HasSubstr("positive"));
    EXPECT_THAT(error_with(at, "att = [1.5, 1]"), HasSubstr("at"));
    EXPECT_THAT(error_with(at, at + "\n[[measured_joint]]\nname = \"bed\"\n" + at),
                HasSubstr("two measured joints 'bed'"));
    EXPECT_EQ(read(changed(at, "at = [1.5, 1.1]\ntolerance = 0.2")).model.measured_joints.size(), 1u);
}

/// The upper face of the base has a corner at which the cross joint ends: it is straight, with the same joint
/// on both sides, and is dropped. So is one on the top of the left block, 1 um off the straight line.
TEST_F(MeasuredJointTest, StraightCornersAreDroppedWhenAsked) {
    blockgen::BlockMesh mesh;
    mesh.vertices = {{0, 0}, {4, 0}, {4, 1}, {2, 1}, {0, 1}, {4, 2}, {2, 2}, {0, 2}, {1, 2.000001}};
    mesh.block_materials = {"rock"};
    mesh.joint_materials = {"bedding"};
    mesh.joints = {{"set"}, {"cross"}};
    const blockgen::EdgeMark face, bed{0, 0}, joint{0, 1};
    mesh.begin_block(0, blockgen::BlockMotion::prescribed, "base");
    mesh.add_ring(std::vector<blockgen::VertexIndex>{0, 1, 2, 3, 4},
                  std::vector<blockgen::EdgeMark>{face, face, bed, bed, face});
    mesh.begin_block(0);
    mesh.add_ring(std::vector<blockgen::VertexIndex>{3, 2, 5, 6},
                  std::vector<blockgen::EdgeMark>{bed, face, face, joint});
    mesh.begin_block(0);
    mesh.add_ring(std::vector<blockgen::VertexIndex>{4, 3, 6, 8, 7},
                  std::vector<blockgen::EdgeMark>{bed, joint, face, face, face});
    blockgen::write_block_file(folder / "two.blocks", mesh);
    const std::string stage = "[[stage]]";
    EXPECT_EQ(read(changed(stage, stage)).model.vertices.size(), 5u + 4 + 5);
    const Model model =
        read(changed("[[measured_joint]]", "[analysis]\nstraight_corners = \"drop\"\n[[measured_joint]]"))
            .model;
    EXPECT_EQ(model.vertices.size(), 4u + 4 + 4);
    EXPECT_EQ(model.topology.joint[2], 0) << "the base's upper face";
    EXPECT_EQ(model.topology.block_corners, (std::vector<dda::CornerIndex>{0, 4, 8, 12}));
    EXPECT_THAT(
        error_with("[[measured_joint]]", "[analysis]\nstraight_corners = \"gone\"\n[[measured_joint]]"),
        HasSubstr("keep"));
}

}  // namespace
}  // namespace rockslope::dda::measured_joint_test
