#include "blockgen/report/repeated_joints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::repeated_joints_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Change> repeated_of(const CutReport& report) {
    std::vector<Change> changes;
    for (const Change& c : report.changes)
        if (c.kind == ChangeKind::joint_repeated) changes.push_back(c);
    return changes;
}

void expect_balanced(const CutReport& report) {
    for (const JointBalance& b : report.joints)
        EXPECT_NEAR(b.input, b.retained + b.pruned + b.on_boundary + b.outside + b.repeated, 1e-4) << b.name;
}

TEST(RepeatedJoints, CountOnceWhereTheyOverlapInPart) {
    // 'b' lies on 'a' from 4 to 10; 'c' runs the other way from 12, of which 8 to 10 is in the rock and on
    // both.
    SlopeModel model = rectangle(10, 4);
    add_trace(model, {{-1, 2}, {10, 2}}, "a");
    add_trace(model, {{4, 2}, {11, 2}}, "b");
    add_trace(model, {{12, 2}, {8, 2}}, "c");
    const CutReport report = cut(model).report;
    EXPECT_EQ(report.blocks, 2u);
    EXPECT_NEAR(report.joints[0].retained, 10, 1e-5);
    EXPECT_EQ(report.joints[0].repeated, 0);
    EXPECT_NEAR(report.joints[1].retained, 0, 1e-5);
    EXPECT_NEAR(report.joints[1].repeated, 6, 1e-5);
    EXPECT_NEAR(report.joints[1].outside, 1, 1e-5);
    EXPECT_NEAR(report.joints[2].repeated, 2, 1e-5);
    expect_balanced(report);
    // Densities of all joints are those of one line across the rock: 10 m in 40 m2.
    EXPECT_NEAR(report.joints[0].p21, 0.25, 1e-6);
    EXPECT_EQ(report.joints[1].p21, 0);
    EXPECT_NEAR(volumetric_joint_count(report.joints), 0.25, 1e-6);
    EXPECT_EQ(report.joints[1].p20, 0);
    EXPECT_THAT(
        report.warnings,
        testing::IsSupersetOf(
            {HasSubstr("1 joint of 'b' runs along earlier ones of 'a' for 6 m, counted once, the first "
                       "at (7, 2)"),
             HasSubstr("1 joint of 'c' runs along earlier ones of 'a' for 2 m")}));
    const std::vector<Change> changes = repeated_of(report);
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_NEAR(changes[0].at.x, 7, 1e-5);
    EXPECT_NEAR(changes[0].length, 6, 1e-5);
    EXPECT_EQ(changes[0].other, "a");
    EXPECT_THAT(report_text(report), HasSubstr("\"repeated_m\""));
    EXPECT_THAT(report_tables(report), HasSubstr("6 m more in the rock along earlier joints"));
}

TEST(RepeatedJoints, OfASetAlongATraceCountWithTheTrace) {
    SlopeModel model = slope(
        "[domain]\noutline = [[0, 0], [10, 0], [10, 10], [0, 10]]\nblock_material = 'rock'\n"
        "[[traces]]\njoint_material = 'fault'\npoints = [[-1, 5], [11, 5]]\n"
        "[[joint_set]]\nname = 'bedding'\nangle = '0 deg'\nspacing = 2\norigin = [0, 5]\n");
    const CutReport report = cut(model).report;
    EXPECT_NEAR(report.joints[0].retained, 10, 1e-5);
    EXPECT_NEAR(report.joints[1].retained, 40, 1e-5);
    EXPECT_NEAR(report.joints[1].repeated, 10, 1e-5);
    EXPECT_NEAR(report.joints[0].p10 + report.joints[1].p10, 0.5, 1e-6);
    expect_balanced(report);
    EXPECT_THAT(
        report.warnings,
        testing::Contains(HasSubstr("1 joint of 'bedding' runs along earlier ones of 'fault' for 10 m")));
}

TEST(RepeatedJoints, ThatEndInRockArePrunedOnce) {
    SlopeModel model = rectangle(10, 4);
    add_trace(model, {{2, 2}, {6, 2}}, "a");
    add_trace(model, {{7, 2}, {3, 2}}, "b");
    const CutReport report = cut(model).report;
    EXPECT_NEAR(report.joints[0].pruned, 4, 1e-5);
    EXPECT_NEAR(report.joints[1].pruned, 1, 1e-5);
    EXPECT_NEAR(report.joints[1].repeated, 3, 1e-5);
    double pruned = 0;
    for (const Change& c : report.changes)
        if (c.kind == ChangeKind::piece_pruned) pruned += c.length;
    EXPECT_NEAR(pruned, 5, 1e-5);
}

TEST(RepeatedJoints, AreNotJointsThatCrossAtASmallAngle) {
    // Within half a grid step of each other over a millimetre or so, which is rounded to one edge.
    SlopeModel model = rectangle(10, 4);
    add_trace(model, {{-1, 2}, {11, 2.001}}, "a");
    add_trace(model, {{-1, 2.001}, {11, 2}}, "b");
    const CutReport report = cut(model).report;
    EXPECT_THAT(repeated_of(report), IsEmpty());
    for (const std::string& warning : report.warnings) EXPECT_THAT(warning, testing::Not(HasSubstr("along")));
    expect_balanced(report);
}

TEST(RepeatedJoints, OfOneNameAreToldInOneLine) {
    SlopeModel model = rectangle(10, 4);
    for (const double y : {1.0, 2.0, 3.0}) {
        add_trace(model, {{-1, y}, {11, y}}, "map");
        add_trace(model, {{5, y}, {9, y}}, "map");
    }
    const CutReport report = cut(model).report;
    EXPECT_THAT(
        report.warnings,
        testing::Contains(HasSubstr("3 joints of 'map' run along earlier ones for 12 m, counted once")));
    EXPECT_NEAR(report.joints[0].retained, 30, 1e-5);
    EXPECT_EQ(repeated_of(report).size(), 3u);
}

}  // namespace
}  // namespace rockslope::blockgen::repeated_joints_test
