#include "blockgen/report/changes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/blockgen/small_blocks.hpp"

namespace rockslope::blockgen::changes_test {
namespace {

using testing::HasSubstr;

std::vector<Change> changes_of(const CutResult& result, ChangeKind kind) {
    std::vector<Change> rows;
    std::copy_if(result.report.changes.begin(), result.report.changes.end(), std::back_inserter(rows),
                 [kind](const Change& c) { return c.kind == kind; });
    return rows;
}

/// The change of a kind, of which there must be exactly one.
Change the(ChangeKind kind, const SlopeModel& model) {
    const std::vector<Change> rows = changes_of(cut(model), kind);
    EXPECT_EQ(rows.size(), 1u);
    return rows.empty() ? Change{} : rows[0];
}

TEST(Changes, AreEmptyWhenEveryJointEndsExactlyOnAnother) {
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{0, 2}, {8, 2}}, "bedding");
    add_trace(model, {{3, 0}, {3, 2}}, "cross");
    add_trace(model, {{0, 0}, {8, 4}}, "diagonal");
    EXPECT_TRUE(cut(model).report.changes.empty());
}

TEST(Changes, AnEndThatStopsShortIsJoined) {
    for (const double gap : {1e-9, 1e-7, 4e-7, -2e-7}) {
        SlopeModel model = rectangle(8, 4);
        add_trace(model, {{0, 2}, {8, 2}}, "bedding");
        add_trace(model, {{3, 0}, {3, 2 - gap}}, "cross");
        const Change joined = the(ChangeKind::end_joined, model);
        EXPECT_EQ(joined.at, (Point{3, 2}));
        EXPECT_NEAR(joined.length, std::abs(gap), 1e-12);
        EXPECT_EQ(joined.joint, "cross");
        EXPECT_EQ(joined.other, "bedding");
    }
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{1e-7, 2}, {8, 2}}, "bedding");
    EXPECT_EQ(the(ChangeKind::end_joined, model).other, "outline");
    // A tip between grid points is rounded, not joined.
    model = rectangle(8, 4);
    add_trace(model, {{0, 2}, {5.1234567891, 2}}, "bedding");
    EXPECT_TRUE(changes_of(cut(model), ChangeKind::end_joined).empty());
}

TEST(Changes, DanglingAndIsolatedPiecesArePruned) {
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{0, 2}, {8, 2}}, "bedding");
    add_trace(model, {{3, 1}, {3, 2.5}}, "cross");  // a dangling end on either side
    add_trace(model, {{5, 3}, {6, 3}, {6, 3.5}}, "loose");
    const std::vector<Change> pruned = changes_of(cut(model), ChangeKind::piece_pruned);
    ASSERT_EQ(pruned.size(), 2u);
    EXPECT_EQ(pruned[0].joint, "cross");
    EXPECT_NEAR(pruned[0].length, 1.5, 1e-12);
    EXPECT_EQ(pruned[0].at, (Point{3, 1.75}));
    EXPECT_EQ(pruned[1].joint, "loose");
    EXPECT_NEAR(pruned[1].length, 1.5, 1e-12);
}

TEST(Changes, GivenTracesWithoutEffectAreDropped) {
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{20, 1}, {20, 4}}, "far");
    add_trace(model, {{2, 0}, {5, 0}}, "floor");
    add_trace(model, {{2, 2}, {2 + 1e-8, 2}}, "point");
    EXPECT_EQ(the(ChangeKind::trace_outside, model).joint, "far");
    EXPECT_NEAR(the(ChangeKind::trace_outside, model).length, 3, 1e-12);
    EXPECT_EQ(the(ChangeKind::trace_on_free_face, model).at, (Point{3.5, 0}));
    EXPECT_EQ(the(ChangeKind::trace_without_length, model).joint, "point");
}

TEST(Changes, ASmallBlockHasARowWithPositionAndArea) {
    const Change merged = the(ChangeKind::block_merged, sliver(SmallBlockPolicy::merge));
    EXPECT_NEAR(merged.at.x, 4, 1e-9);
    EXPECT_NEAR(merged.at.y, 2.03125, 1e-9);
    EXPECT_EQ(merged.area, 0.5);
    EXPECT_EQ(merged.length, 8);
    const Change dropped = the(ChangeKind::piece_dropped, sliver(SmallBlockPolicy::drop));
    EXPECT_EQ(dropped.joint, "lower");
    EXPECT_EQ(dropped.area, 0.5);
    EXPECT_EQ(dropped.length, 8);
}

TEST(Changes, IslandsFilledAndCutHaveTheirRows) {
    SlopeModel model = rectangle(8, 8);
    add_trace(model, {{2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}}, "ring");
    model.islands = IslandPolicy::fill;
    const Change filled = the(ChangeKind::island_filled, model);
    EXPECT_NEAR(filled.area, 4, 1e-12);
    EXPECT_NEAR(filled.at.x, 3, 1e-9);
    EXPECT_NEAR(filled.at.y, 3, 1e-9);
    model.islands = IslandPolicy::cut;
    const std::vector<Change> cuts = changes_of(cut(model), ChangeKind::island_cut);
    EXPECT_EQ(cuts.size(), cut(model).report.island_cuts);
    ASSERT_FALSE(cuts.empty());
    EXPECT_GT(cuts[0].length, 1.9);
}

TEST(Changes, AreInBothReportsAndLongListsAreTruncatedInTheTables) {
    SlopeModel model = rectangle(100, 4);
    for (int k = 1; k < 60; ++k) {
        const double x = k;
        add_trace(model, {{x, 1}, {x, 2}}, "tip");
    }
    const CutResult result = cut(model);
    EXPECT_THAT(report_tables(result.report), HasSubstr("joint piece pruned"));
    EXPECT_THAT(report_tables(result.report), HasSubstr("and 39 more; the JSON report lists all"));
    const std::string json = report_text(result.report);
    std::size_t rows = 0;
    for (auto at = json.find("joint piece pruned"); at != std::string::npos;
         at = json.find("joint piece pruned", at + 1))
        ++rows;
    EXPECT_EQ(rows, 59u);
}

}  // namespace
}  // namespace rockslope::blockgen::changes_test
