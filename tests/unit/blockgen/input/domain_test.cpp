#include "blockgen/input/domain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::domain_test {
namespace {

using testing::HasSubstr;

/// Two squares of 2 m, `gap` apart, cut by one joint through both.
SlopeModel two_squares(double gap) {
    SlopeModel model = rectangle(2, 2);
    model.further_outlines = {{{2 + gap, 0}, {4 + gap, 0}, {4 + gap, 2}, {2 + gap, 2}}};
    add_trace(model, {{-1, 1}, {7, 1}}, "bedding");
    return model;
}

TEST(Domain, PartsAreCutSeparately) {
    const CutResult result = cut(two_squares(1));
    EXPECT_EQ(result.report.blocks, 4u);
    EXPECT_EQ(result.report.domain_area, 8);
    EXPECT_NEAR(result.report.joints[0].retained, 4, 1e-12);
    EXPECT_NEAR(result.report.joints[0].outside, 4, 1e-12);
    EXPECT_EQ(result.report.boundary_edges, 12u);
}

TEST(Domain, PartsThatTouchAreOneRock) {
    const CutResult result = cut(two_squares(0));
    EXPECT_EQ(result.report.blocks, 2u);
    EXPECT_EQ(result.report.domain_area, 8);
    EXPECT_EQ(result.report.boundary_edges, 6u);
}

TEST(Domain, BoundsAndContainmentCoverAllParts) {
    const SlopeModel model = two_squares(1);
    EXPECT_EQ(domain_bounds(model).high, (Point{5, 2}));
    EXPECT_TRUE(is_in_outlines(model, {1, 1}));
    EXPECT_TRUE(is_in_outlines(model, {4, 1}));
    EXPECT_FALSE(is_in_outlines(model, {2.5, 1}));
}

TEST(Domain, SetsFillAllPartsWithTheirDensity) {
    SlopeModel model = slope(R"([domain]
outlines = [[[0, 0], [40, 0], [40, 30], [0, 30]], [[60, 0], [100, 0], [100, 30], [60, 30]]]
block_material = "rock"
[[joint_set]]
name = "random"
kind = "baecher"
angle = { law = "uniform", min = "0 deg", max = "180 deg" }
trace_length = 5
p21 = 1.5
)");
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.domain_area, 2400);
    EXPECT_NEAR(result.report.joints[0].p21, 1.5, 5.0 / 2400);  // tolerance: half of the last trace
    for (const auto& [low, high] : {std::pair(0, 40), std::pair(60, 100)}) {
        SlopeModel part = model;
        part.outline = {{low * 1.0, 0}, {high * 1.0, 0}, {high * 1.0, 30}, {low * 1.0, 30}};
        part.further_outlines.clear();
        const CutResult alone = cut_blocks(part, all_traces(model));
        // 360 traces of 5 m in each part: the standard deviation of their number is about 5 %.
        EXPECT_NEAR(alone.report.joints[0].p21, 1.5, 0.3);
    }
}

std::string error_of(const std::string& domain) {
    return rockslope::error_of([&] { cut(slope("[domain]\nblock_material = \"rock\"\n" + domain)); });
}

std::string ring_text(const Ring& ring) {
    std::string text;
    for (const Point& p : ring)
        text += (text.empty() ? "[" : ", [") + std::to_string(p.x) + ", " + std::to_string(p.y) + "]";
    return "[" + text + "]";
}

TEST(Domain, PartsThatShareAnInclinedEdgeTouch) {
    const SlopeModel model = slope(R"([domain]
outlines = [[[0.1, 0], [10.2, 3.3], [1, 9]], [[10.2, 3.3], [0.1, 0], [9, -4]]]
block_material = "rock"
)");
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.blocks, 1u);
    EXPECT_EQ(result.report.boundary_edges, 4u);
}

/// Triangles on both sides of an edge, in the six digits that a file has.
TEST(Domain, NoPairOfTrianglesOnBothSidesOfAnEdgeOverlaps) {
    std::mt19937_64 random(7);
    const auto draw = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    for (int pair = 0; pair < 200; ++pair) {
        const Point a{draw(0, 3), draw(0, 3)}, b{draw(7, 10), draw(7, 10)};
        const Point left{draw(0, 2), draw(8, 10)}, right{draw(8, 10), draw(0, 2)};
        const std::string outlines =
            "outlines = [" + ring_text({a, b, left}) + ", " + ring_text({b, a, right}) + "]";
        EXPECT_EQ(error_of(outlines), "no error") << outlines;
        // The same pair, the second moved into the first by a hundredth of a metre.
        const Point down{b.x - 0.01, b.y + 0.01}, up{a.x - 0.01, a.y + 0.01};
        EXPECT_THAT(
            error_of("outlines = [" + ring_text({a, b, left}) + ", " + ring_text({down, up, right}) + "]"),
            HasSubstr("outline 2 overlaps outline 1 at ("))
            << outlines;
    }
}

TEST(Domain, AnOverlapNamesBothPartsAndItsPlace) {
    const std::string square = "[[0, 0], [2, 0], [2, 2], [0, 2]]",
                      far = "[[20, 0], [22, 0], [22, 2], [20, 2]]";
    EXPECT_THAT(
        error_of("outlines = [" + square + ", " + far + ", [[21, 1], [25, 1], [25, 3], [21, 3]]]"),
        HasSubstr("slope.toml:3:12: outline 3 overlaps outline 2 at (21.5, 1.5); overlaps make 1 m2 in all"));
    // One inside the other.
    EXPECT_THAT(error_of("outlines = [" + square + ", [[0.5, 0.5], [1, 0.5], [1, 1]]]"),
                HasSubstr("outline 2 overlaps outline 1"));
}

TEST(Domain, InvalidPartsAreReported) {
    const std::string square = "[[0, 0], [2, 0], [2, 2], [0, 2]]";
    EXPECT_EQ(error_of("outlines = [" + square + ", [[2, 0], [4, 0], [4, 2]]]"), "no error");
    EXPECT_THAT(error_of("outlines = [" + square + ", [[1, 0], [4, 0], [4, 2]]]"),
                HasSubstr("outline 2 overlaps outline 1"));
    EXPECT_THAT(error_of("outlines = [" + square + ", " + square + "]"), HasSubstr("outline 2 overlaps"));
    EXPECT_THAT(error_of("outlines = [" + square + ", [[5, 0], [6, 0]]]"), HasSubstr("outline 2: 2 corners"));
    EXPECT_THAT(error_of("outlines = []"), HasSubstr("no part of the domain"));
    EXPECT_THAT(error_of("outline = " + square + "\noutlines = [" + square + "]"),
                HasSubstr("outline and outlines are both given"));
    EXPECT_THAT(error_of("outlines = [" + square + "]\nholes = [[[5, 5], [6, 5], [6, 6]]]"),
                HasSubstr("hole 1 lies outside the outline"));
    // Joint sets are drawn in the bare rock, which knows the place, too.
    EXPECT_THAT(error_of("outline = " + square +
                         "\nholes = [[[5, 5], [6, 5], [6, 6]]]\n[[joint_set]]\n"
                         "name = \"a\"\nangle = \"10 deg\"\nspacing = 1"),
                testing::ContainsRegex(":[0-9]+:9: hole 1 lies outside the outline"));
}

}  // namespace
}  // namespace rockslope::blockgen::domain_test
