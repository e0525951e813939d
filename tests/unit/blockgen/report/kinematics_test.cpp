#include "blockgen/report/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blockgen/cut/apply_block_selectors.hpp"
#include "common/base/input_error.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::kinematics_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A bench whose face falls to the right at 45 degrees from (10, 15) to (20, 5).
SlopeModel bench() {
    SlopeModel model = rectangle(1, 1);
    model.outline = {{0, 0}, {20, 0}, {20, 5}, {10, 15}, {0, 15}};
    model.kinematics = KinematicScreen{35 * degree};
    return model;
}

BlockMode mode_at(const CutResult& result, const Point& p) {
    return result.report.kinematics->mode[block_at(result.mesh, p)];
}

TEST(Kinematics, ASlabOnADaylightingJointSlides) {
    for (const double dip : {20.0, 30.0, 40.0}) {
        SlopeModel model = bench();
        const double slope = std::tan(dip * degree);
        add_trace(model, {{18, 8 - slope}, {7, 8 + 10 * slope}}, "plane");
        add_trace(model, {{8, 16}, {8, 8 + 9 * slope}}, "crack");
        const CutResult result = cut(model);
        ASSERT_EQ(result.report.kinematics->blocks.size(), 1u) << dip;
        const KeyBlock& key = result.report.kinematics->blocks.at(0);
        EXPECT_EQ(key.mode, BlockMode::sliding);
        EXPECT_NEAR(key.factor_of_safety, std::tan(35 * degree) / slope, 1e-5);
        EXPECT_NEAR(key.direction.x, std::cos(dip * degree), 1e-6);
        EXPECT_EQ(result.mesh.joints[key.joint].set, "plane");
        EXPECT_EQ(key.block, block_at(result.mesh, {12, 12.5}));
        // The fixed side of the model holds the block below.
        EXPECT_EQ(mode_at(result, {2, 2}), BlockMode::tapered);
    }
}

TEST(Kinematics, AJointThatDipsIntoTheSlopeHoldsItsBlock) {
    SlopeModel model = bench();
    add_trace(model, {{18, 7}, {5, 5}, {5, 16}}, "back");
    const CutResult result = cut(model);
    EXPECT_TRUE(result.report.kinematics->blocks.empty());
    EXPECT_EQ(mode_at(result, {10, 12}), BlockMode::stable);
}

SlopeModel roof(const Point& left, const Point& right, const std::vector<Point>& above) {
    SlopeModel model = rectangle(20, 20);
    model.kinematics = KinematicScreen{30 * degree, {"bottom", "left", "right", "top"}};
    model.tunnels.push_back({"t", {{6, 4}, {14, 4}, {14, 10}, {6, 10}}, {}});
    std::vector<Point> line = {left};
    line.insert(line.end(), above.begin(), above.end());
    line.push_back(right);
    add_trace(model, line);
    return model;
}

TEST(Kinematics, BlocksOfARoof) {
    // A wedge that narrows upwards falls, one that widens upwards is tapered; a block with vertical sides
    // slides without friction.
    CutResult result = cut(roof({8, 10}, {12, 10}, {{10, 13}}));
    EXPECT_EQ(mode_at(result, {10, 11}), BlockMode::falling);
    EXPECT_EQ(result.report.kinematics->blocks.at(0).factor_of_safety, 0);
    EXPECT_EQ(mode_at(result, {10, 16}), BlockMode::tapered);
    result = cut(roof({9, 10}, {11, 10}, {{8, 13}, {12, 13}}));
    EXPECT_EQ(mode_at(result, {10, 11}), BlockMode::tapered);
    result = cut(roof({9, 10}, {11, 10}, {{9, 13}, {11, 13}}));
    EXPECT_EQ(mode_at(result, {10, 11}), BlockMode::sliding_two_faces);
    EXPECT_NEAR(result.report.kinematics->blocks.at(0).factor_of_safety, 0, 1e-5);
    // The block rests on its right side, at tan = 3; its left side overhangs: tan 30 / 3.
    result = cut(roof({9, 10}, {12, 10}, {{9 + 3 / std::tan(60 * degree), 13}, {13, 13}}));
    EXPECT_EQ(mode_at(result, {11, 11}), BlockMode::sliding);
    EXPECT_NEAR(result.report.kinematics->blocks.at(0).factor_of_safety, std::tan(30 * degree) / 3, 1e-5);
    // The block rests on its left side at 60 degrees. It is removable when the right side is flatter, at
    // tan = 2/1.2, and tapered when the right side is steeper.
    result = cut(roof({9, 10}, {12, 10}, {{9 - 2 / std::tan(60 * degree), 12}, {10.8, 12}}));
    EXPECT_EQ(mode_at(result, {10, 11}), BlockMode::sliding);
    EXPECT_NEAR(result.report.kinematics->blocks.at(0).factor_of_safety, 1.0 / 3, 1e-5);
    result = cut(roof({9, 10}, {12, 10}, {{9 - 2 / std::tan(60 * degree), 12}, {11, 12}}));
    EXPECT_EQ(mode_at(result, {10, 11}), BlockMode::tapered);
}

TEST(Kinematics, BlocksOnTheGround) {
    SlopeModel model = rectangle(10, 6);
    model.kinematics = KinematicScreen{30 * degree};
    add_trace(model, {{2, 6}, {3, 4}, {4, 6}});          // a block in a notch can only be lifted
    add_trace(model, {{6, 6}, {6, 5}, {8, 5}, {8, 6}});  // the same for a block in a box
    const CutResult result = cut(model);
    EXPECT_EQ(mode_at(result, {3, 5.5}), BlockMode::stable);
    EXPECT_EQ(mode_at(result, {7, 5.5}), BlockMode::stable);
    EXPECT_TRUE(result.report.kinematics->blocks.empty());
}

TEST(Kinematics, TwoStepsOfOneDipAreTwoFaces) {
    SlopeModel model = bench();
    // A stepped joint with two treads that dip at 20 degrees; the riser between them opens during sliding.
    const double t = std::tan(20 * degree);
    add_trace(model, {{20, 6.5 - 2 * t}, {15, 6.5 + 3 * t}, {15, 7.5 + 3 * t}, {9, 7.5 + 9 * t}, {9, 16}},
              "steps");
    const CutResult result = cut(model);
    ASSERT_EQ(result.report.kinematics->blocks.size(), 1u);
    EXPECT_EQ(result.report.kinematics->blocks.at(0).mode, BlockMode::sliding_two_faces);
    EXPECT_NEAR(result.report.kinematics->blocks.at(0).factor_of_safety, std::tan(35 * degree) / t, 1e-5);
}

TEST(Kinematics, BlocksBetweenSnappedParallelJointsCanSlideOut) {
    // Snapping rotates each edge a little: without a tolerance the slab would be wedged between its joints.
    SlopeModel model = bench();
    for (const double y : {7.0, 8.3}) add_trace(model, {{21, y - 0.5237 * 4}, {1, y + 0.5237 * 16}});
    add_trace(model, {{6.1, 5}, {6.1, 16}});
    const CutResult result = cut(model);
    EXPECT_EQ(mode_at(result, {13, 9.7}), BlockMode::sliding_two_faces);
}

TEST(Kinematics, KeysOfTheModelFile) {
    const std::string head =
        "[domain]\noutline = [[0, 0], [20, 0], [20, 10], [0, 10]]\nblock_material = \"rock\"\n[kinematics]\n";
    const SlopeModel model = slope(head + "friction_angle = \"30 deg\"\nfixed_sides = [\"left\"]\n");
    ASSERT_TRUE(model.kinematics.has_value());
    EXPECT_NEAR(model.kinematics->friction_angle, 30 * degree, 1e-15);
    EXPECT_EQ(model.kinematics->fixed_sides, (std::vector<std::string>{"left"}));
    EXPECT_NE(report_text(cut(model).report).find("\"kinematics\""), std::string::npos);
    for (const char* bad :
         {"friction_angle = 30", "friction_angle = \"-3 deg\"", "friction_angle = \"90 deg\"",
          "fixed_sides = [\"left\"]", "friction_angle = \"30 deg\"\nfixed_sides = [\"under\"]",
          "friction_angle = \"30 deg\"\ncohesion = 3"})
        EXPECT_THROW(slope(head + bad + "\n"), InputError) << bad;
}

TEST(Kinematics, FrictionIsThatOfTheJointsMaterial) {
    for (const double friction : {10.0, 25.0, 50.0}) {
        SlopeModel model = bench();
        model.kinematics->friction_of_material = {{"plane", friction * degree}, {"crack", 1 * degree}};
        add_trace(model, {{19, 7.5}, {7, 13.5}}, "plane");
        add_trace(model, {{8, 16}, {8, 13}}, "crack");
        const KinematicReport report = *cut(model).report.kinematics;
        ASSERT_EQ(report.blocks.size(), 1u);
        EXPECT_NEAR(report.blocks[0].factor_of_safety, 2 * std::tan(friction * degree), 1e-5);
    }
}

TEST(Kinematics, JointsOfTwoMaterialsInOneLineCarryByTheirLengths) {
    SlopeModel model = bench();
    model.kinematics->friction_of_material = {{"lower", 20 * degree}};
    add_trace(model, {{19, 7.5}, {12, 11}}, "lower");
    add_trace(model, {{12, 11}, {7, 13.5}}, "upper");
    add_trace(model, {{8, 16}, {8, 13}}, "crack");
    const KinematicReport report = *cut(model).report.kinematics;
    ASSERT_EQ(report.blocks.size(), 1u);
    // The joint runs from the face at x = 16 to the crack at x = 8, in two halves of equal length.
    EXPECT_NEAR(report.blocks[0].factor_of_safety, 2 * (std::tan(20 * degree) + std::tan(35 * degree)) / 2,
                1e-5);
}

TEST(Kinematics, AFrictionAngleOfAMaterialThatNoJointHasIsRefused) {
    const std::string text = R"([domain]
outline = [[0, 0], [20, 0], [20, 5], [10, 15], [0, 15]]
block_material = "rock"
[[traces]]
joint_material = "plane"
points = [[19, 7.5], [7, 13.5]]
[kinematics]
friction_angle = "35 deg"
[kinematics.friction_angles]
)";
    EXPECT_NEAR(slope(text + "plane = \"20 deg\"").kinematics->friction_of_material.at("plane"), 20 * degree,
                1e-12);
    EXPECT_THROW(slope(text + "plain = \"20 deg\""), InputError);
    EXPECT_THROW(slope(text + "plane = \"90 deg\""), InputError);
    EXPECT_THROW(slope(text + "plane = 20"), InputError);
}

}  // namespace
}  // namespace rockslope::blockgen::kinematics_test
