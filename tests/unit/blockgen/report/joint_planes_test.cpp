#include "blockgen/report/joint_planes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blockgen/sampling/set_sampler.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::joint_planes_test {
namespace {

using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;

const std::string rock = R"(
[domain]
outline = [[0, 0], [30, 0], [30, 20], [0, 20]]
block_material = "rock"
[section]
azimuth = "90 deg"
)";

TEST(JointPlanes, AreThoseOfASetWithoutScatter) {
    // The worked example: the set dips by 56.31 degrees in the section, its lines are 2.2188 m apart. Their
    // feet on the lower side and its prolongation to the left are 2.6667 m apart, and lie over 30 + 20 / 1.5.
    const SlopeModel model =
        slope(rock +
              "[[joint_set]]\nname = 'planes'\ndip = '60 deg'\ndip_direction = '120 deg'\n"
              "spacing = 2\norigin = [1, 0]\n[[joint_set]]\nname = 'angle'\nangle = '5 deg'\n"
              "spacing = 3\n");
    const CutReport report = cut(model).report;
    ASSERT_EQ(report.planes.size(), 1u);
    const JointPlanes& planes = report.planes[0];
    EXPECT_EQ(planes.name, "planes");
    EXPECT_EQ(planes.planes.size(), 16u);  // at 1 + 2.6667 k, between 0 and 43.33
    EXPECT_NEAR(planes.mean.dip, 60 * degree, 1e-12);
    EXPECT_NEAR(planes.mean.dip_direction, 120 * degree, 1e-12);
    EXPECT_FALSE(planes.k);
    EXPECT_THAT(report_text(report), HasSubstr("\"planes\": 16"));
    EXPECT_THAT(report_tables(report), HasSubstr("planes                  16     60.00         120.00"));
    // 16 equal poles: the largest value of the kernel, k / (1 - exp(-k)) for k = 2 (1 + 16 / 9).
    ASSERT_TRUE(report.densest_planes);
    EXPECT_EQ(report.densest_planes->count, 16u);
    EXPECT_NEAR(report.densest_planes->density, 5.5771, 1e-4);
    EXPECT_NEAR(report.densest_planes->plane.dip, 60 * degree, 1e-7);
    EXPECT_NEAR(report.densest_planes->plane.dip_direction, 120 * degree, 1e-7);
    EXPECT_THAT(report_text(report), HasSubstr("\"densest_planes\": {\n    \"poles\": 16,"));
    EXPECT_THAT(report_tables(report),
                HasSubstr("Densest of 16 poles: 60.00/120.00, 5.58 % of them for 1 %"));
}

TEST(JointPlanes, AreThoseThatTheTracesWereDrawnFrom) {
    SlopeModel model = slope(rock + R"(
[[region]]
name = "left"
block_material = "other"
joint_material = "contact"
polygon = [[0, 0], [15, 0], [15, 20], [0, 20]]
[[joint_set]]
name = "scattered"
dip = "50 deg"
dip_direction = "70 deg"
fisher_k = 40
spacing = 0.7
trace_length = 3
gap = 1
[[joint_set]]
name = "regional"
kind = "baecher"
orientations = [["80 deg", "10 deg"], ["85 deg", "190 deg"], ["70 deg", "15 deg"]]
trace_length = 4
p21 = 1
region = "left"
)");
    const std::vector<Trace> traces = all_traces(model);
    const CutReport report = cut(model).report;
    ASSERT_EQ(report.planes.size(), 2u);
    // Each trace runs along the line in which its plane meets the section, for tan a = -(n.x) / (n.up).
    std::size_t compared = 0;
    for (const Trace& trace : traces) {
        ASSERT_TRUE(trace.draw);
        const JointSet& set = model.joint_sets[trace.name == "regional"];
        const double angle = trace_angle(SetSampler(set, model, {}).plane(*trace.draw));
        const Point u{trace.points[1].x - trace.points[0].x, trace.points[1].y - trace.points[0].y};
        EXPECT_NEAR(std::cos(angle) * u.y - std::sin(angle) * u.x, 0, 1e-9);
        ++compared;
    }
    EXPECT_GT(compared, 200u);
    // A line of traces and rock bridges counts once.
    EXPECT_LT(report.planes[0].planes.size(), report.joints[0].traces / 3);
    EXPECT_GT(report.planes[0].planes.size(), 20u);
    EXPECT_EQ(report.planes[0].asked_k, 40);
    EXPECT_NEAR(report.planes[0].mean.dip, 50 * degree, 6 * degree);
    ASSERT_TRUE(report.planes[1].k);
    for (const PlaneAngles& plane : report.planes[1].planes) EXPECT_GE(plane.dip, 69.9 * degree);
}

TEST(JointPlanes, WithoutPlanesInSpaceLeaveTheReportAsItWas) {
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{-1, 2}, {9, 2}});
    const CutReport report = cut(model).report;
    EXPECT_TRUE(report.planes.empty());
    EXPECT_FALSE(report.densest_planes);
    EXPECT_THAT(report_text(report), testing::Not(HasSubstr("\"planes\"")));
}

}  // namespace
}  // namespace rockslope::blockgen::joint_planes_test
