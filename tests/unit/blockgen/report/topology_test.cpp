#include "blockgen/report/topology.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::topology_test {
namespace {

using testing::HasSubstr;

Topology topology_of_slope(const SlopeModel& model) {
    return cut(model).report.topology;
}

TEST(Topology, OfACrossAnAbutmentAndATip) {
    SlopeModel model = rectangle(10, 10);
    // A joint through the rock, one that crosses it and ends in rock, and one that abuts.
    add_trace(model, {{-1, 5}, {11, 5}});
    add_trace(model, {{3, 3}, {3, 7}});
    add_trace(model, {{7, 5}, {7, 8}});
    // Apart from these: a bent crack of 2 m, and a closed line of 4 m.
    add_trace(model, {{5, 1}, {6, 1}, {6, 2}});
    add_trace(model, {{8, 1}, {9, 1}, {9, 2}, {8, 2}, {8, 1}});
    const Topology t = topology_of_slope(model);
    EXPECT_EQ(t.nodes.x, 1u);
    EXPECT_EQ(t.nodes.y, 1u);
    EXPECT_EQ(t.nodes.i, 5u);
    EXPECT_EQ(t.nodes.edge, 2u);
    // Three along the joint through the rock, two of the crossing one, one each of the others.
    EXPECT_EQ(t.branches, 8u);
    EXPECT_EQ(t.clusters, 3u);
    EXPECT_NEAR(t.largest_cluster, 17.0 / 23, 1e-9);
}

TEST(Topology, OfRockWithoutJointsIsEmpty) {
    const Topology t = topology_of_slope(rectangle(2, 1));
    EXPECT_EQ(t.branches + t.clusters + t.nodes.edge, 0u);
    EXPECT_EQ(t.largest_cluster, 0);
}

// (I + 3 Y + 4 X + E) / 2 branches, where each end at a free face is one (Sanderson and Nixon 2015).
TEST(Topology, BranchesFollowFromTheNodes) {
    const SlopeModel model = slope(R"(seed = 2
[domain]
outline = [[0, 0], [20, 0], [20, 20], [0, 20]]
block_material = "rock"
[[joint_set]]
name = "a"
kind = "baecher"
angle = { law = "normal", mean = "20 deg", sd = "20 deg" }
trace_length = 4
p21 = 1.5
)");
    const CutResult result = cut(model);
    const Topology& t = result.report.topology;
    EXPECT_EQ(2 * t.branches, t.nodes.i + 3 * t.nodes.y + 4 * t.nodes.x + t.nodes.edge);
    EXPECT_GT(t.nodes.x, 30u);
    EXPECT_THAT(report_text(result.report), HasSubstr("\"clusters\": " + std::to_string(t.clusters)));
    EXPECT_THAT(report_tables(result.report), HasSubstr(std::to_string(t.branches) + " branches"));
}

}  // namespace
}  // namespace rockslope::blockgen::topology_test
