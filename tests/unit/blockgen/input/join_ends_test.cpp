#include "blockgen/input/join_ends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::join_ends_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A map of a wall of 7 x 5 bricks, each joint drawn from junction to junction in pieces of a metre. Ends
/// miss their junctions by up to `miss`, m, in any direction.
SlopeModel sloppy_map(double miss, std::uint64_t seed, std::vector<double>* gaps = nullptr) {
    std::mt19937_64 random(seed);
    const auto off = [&](double x, double y) {
        const double r = miss * std::sqrt(uniform(random, 0, 1)), a = uniform(random, 0, 2 * M_PI);
        if (gaps != nullptr) gaps->push_back(r);
        return Point{x + r * std::cos(a), y + r * std::sin(a)};
    };
    SlopeModel model = rectangle(7, 5);
    for (int row = 1; row < 5; ++row)
        for (int column = 0; column < 7; ++column)
            add_trace(model, {off(column, row), off(column + 1, row)}, "bed");
    for (int row = 0; row < 5; ++row)
        for (int column = 1; column < 7; ++column) {
            const double x = column + (row % 2 == 0 ? 0 : 0.5);
            if (x < 7) add_trace(model, {off(x, row), off(x, row + 1)}, "head");
        }
    return model;
}

std::size_t blocks(const SlopeModel& model) {
    return cut(model).report.blocks;
}

TEST(JoinEnds, AWallOfBricksIsWholeAgain) {
    // Rows without an offset have 7 bricks, the two others 6 whole ones and one and a half at an end.
    const std::size_t bricks = 3 * 7 + 2 * 7;
    EXPECT_EQ(blocks(sloppy_map(0, 1)), bricks);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SlopeModel model = sloppy_map(0.004, seed);
        EXPECT_LT(blocks(model), bricks / 2);
        join_ends(0.01, model);
        EXPECT_EQ(blocks(model), bricks) << "seed " << seed;
        EXPECT_EQ(model.trace_ends.near_misses.size(), 0u);
        for (const NearEnd& end : model.trace_ends.joined) EXPECT_LE(end.gap, 0.01);
    }
}

TEST(JoinEnds, WithoutSnapTheMissesAreCountedAndAValueSuggested) {
    SlopeModel model = sloppy_map(0.004, 1);
    const std::vector<Trace> before = model.traces;
    join_ends(0, model);
    for (std::size_t t = 0; t < before.size(); ++t) EXPECT_EQ(model.traces[t].points, before[t].points);
    EXPECT_GT(model.trace_ends.near_misses.size(), 40u);
    EXPECT_GE(model.trace_ends.suggested_snap, 0.002);
    EXPECT_LE(model.trace_ends.suggested_snap, 0.01);
    EXPECT_THAT(model.notes, Contains(HasSubstr("in [domain] joins them; the first is at (")));
    // The value is that of a sample: the widest gap of a map may be beyond it.
    int whole = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SlopeModel counted = sloppy_map(0.004, seed), joined = counted;
        join_ends(0, counted);
        join_ends(counted.trace_ends.suggested_snap, joined);
        const std::size_t found = blocks(joined);
        EXPECT_GE(found, 34u) << "seed " << seed;
        whole += found == 35;
    }
    EXPECT_GE(whole, 18);  // 19 today
}

TEST(JoinEnds, TracesPlacedAtRandomSuggestNothing) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        std::mt19937_64 random(seed);
        SlopeModel model = rectangle(30, 20);
        for (int k = 0; k < 400; ++k) {
            const Point a{uniform(random, 0, 30), uniform(random, 0, 20)};
            const double angle = uniform(random, 0, M_PI);
            add_trace(model, {a, {a.x + 2 * std::cos(angle), a.y + 2 * std::sin(angle)}});
        }
        join_ends(0, model);
        EXPECT_EQ(model.trace_ends.suggested_snap, 0) << "seed " << seed;
        EXPECT_EQ(model.notes.size(), 0u);
    }
}

TEST(JoinEnds, AnEndMeetsAnEndATraceOrAnOutline) {
    SlopeModel model = rectangle(10, 10);
    add_trace(model, {{0.02, 5}, {9.97, 5}}, "bed");           // stops short of both sides
    add_trace(model, {{3, 5.03}, {3, 7}, {3, 9.99}}, "head");  // of the bed and the top
    add_trace(model, {{6, 0}, {6, 4.96}}, "foot");             // of the bed from below
    add_trace(model, {{6, 5.02}, {6.01, 10}}, "cap");          // of the bed, 6 cm from the foot
    join_ends(0.05, model);
    EXPECT_EQ(model.traces[0].points.front(), (Point{0, 5}));
    EXPECT_EQ(model.traces[0].points.back(), (Point{10, 5}));
    EXPECT_EQ(model.traces[1].points.front(), (Point{3, 5}));
    EXPECT_EQ(model.traces[1].points.back(), (Point{3, 10}));
    EXPECT_THAT(model.traces[0].points, Contains(Point{3, 5}));
    EXPECT_EQ(model.trace_ends.joined.size(), 6u);
    EXPECT_EQ(blocks(model), 5u);
}

TEST(JoinEnds, AnEndThatIsJoinedOrCrossesStays) {
    SlopeModel model = rectangle(10, 10);
    add_trace(model, {{0, 5}, {10, 5}}, "bed");
    add_trace(model, {{3, 5}, {3, 10}}, "joined");
    add_trace(model, {{6, 4.98}, {6, 10.02}}, "crosses");
    const std::vector<Trace> before = model.traces;
    join_ends(0.05, model);
    for (std::size_t t = 0; t < before.size(); ++t) EXPECT_EQ(model.traces[t].points, before[t].points);
    EXPECT_EQ(model.trace_ends.joined.size(), 0u);
}

/// Points of all traces, sorted: what was made, whatever the order.
std::vector<std::vector<Point>> shapes(const SlopeModel& model) {
    std::vector<std::vector<Point>> result;
    for (const Trace& trace : model.traces) result.push_back(trace.points);
    const auto less = [](const Point& p, const Point& q) {
        return std::pair(p.x, p.y) < std::pair(q.x, q.y);
    };
    std::sort(result.begin(), result.end(), [&](const auto& a, const auto& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
    });
    return result;
}

TEST(JoinEnds, TheOrderOfTheTracesChangesNothing) {
    SlopeModel model = sloppy_map(0.004, 5);
    SlopeModel shuffled = model;
    std::shuffle(shuffled.traces.begin(), shuffled.traces.end(), std::mt19937_64(3));
    join_ends(0.01, model);
    join_ends(0.01, shuffled);
    EXPECT_EQ(shapes(model), shapes(shuffled));
}

TEST(JoinEnds, IsAKeyOfTheModelFileAndInTheReport) {
    const std::string text =
        "[domain]\noutline = [[0, 0], [10, 0], [10, 10], [0, 10]]\nblock_material = \"rock\"\n"
        "[[traces]]\njoint_material = \"bed\"\npoints = [[0.02, 5], [10, 5]]\n";
    EXPECT_EQ(cut(slope(text)).report.blocks, 1u);
    std::string snapped = text;
    snapped.replace(snapped.find("block_material"), 0, "snap = \"3 cm\"\n");
    const CutReport report = cut(slope(snapped)).report;
    EXPECT_EQ(report.blocks, 2u);
    ASSERT_EQ(report.changes.size(), 1u);
    EXPECT_EQ(report.changes[0].kind, ChangeKind::end_snapped);
    EXPECT_NEAR(report.changes[0].length, 0.02, 1e-12);
    EXPECT_EQ(report.changes[0].other, "outline");
}

}  // namespace
}  // namespace rockslope::blockgen::join_ends_test
