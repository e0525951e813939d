#include "blockgen/input/repeated_traces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::repeated_traces_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SlopeModel model_of(const std::vector<std::vector<Point>>& traces, const std::string& name = "fault") {
    SlopeModel model = rectangle(10, 10);
    for (const std::vector<Point>& points : traces) add_trace(model, points, name);
    return model;
}

TEST(RepeatedTraces, AreFoundInBothDirectionsAndWithOtherVertices) {
    SlopeModel model = model_of({{{0, 1}, {4, 3}, {9, 3}},
                                 {{9, 3}, {4, 3}, {0, 1}},
                                 {{0, 1}, {2, 2}, {4, 3}, {6, 3}, {6, 3}, {9, 3}},
                                 {{9, 3}, {7, 3}, {4, 3}, {0, 1}}});
    drop_repeated_traces(model);
    EXPECT_EQ(model.traces.size(), 1u);
    EXPECT_THAT(model.notes,
                ElementsAre("3 traces of 'fault' repeat earlier ones and are dropped, the first at (9, 3)"));
    EXPECT_TRUE(model.repeated_names.empty());
}

TEST(RepeatedTraces, AreNotThoseOfAnotherCourse) {
    // Other corners, a piece of the same line, a line that goes there and back, and a vertex a bit off it.
    SlopeModel model = model_of({{{0, 1}, {4, 3}, {9, 3}},
                                 {{0, 1}, {4, 3.001}, {9, 3}},
                                 {{0, 1}, {4, 3}},
                                 {{0, 1}, {9, 3}},
                                 {{0, 1}, {9, 3}, {4, 17. / 9}, {9, 3}},
                                 {{0, 1}, {4, 3}, {9, 3}, {4, 3}, {0, 1}}});
    drop_repeated_traces(model);
    EXPECT_EQ(model.traces.size(), 6u);
    EXPECT_TRUE(model.notes.empty());
}

TEST(RepeatedTraces, AreToldByNamesAndMaterial) {
    SlopeModel model = model_of({{{0, 1}, {9, 3}}, {{0, 5}, {9, 5}}});
    add_trace(model, {{9, 3}, {0, 1}}, "scan");
    add_trace(model, {{9, 5}, {0, 5}}, "scan");
    add_trace(model, {{0, 7}, {9, 7}}, "map");
    add_trace(model, {{0, 7}, {9, 7}}, "map");
    model.traces.back().joint_material = "clay";
    drop_repeated_traces(model);
    EXPECT_EQ(model.traces.size(), 3u);
    EXPECT_THAT(
        model.notes,
        ElementsAre("2 traces of 'scan' repeat earlier ones of 'fault' and are dropped, the first at (9, 3); "
                    "the joint material of 2 is another one, and that of the earlier holds",
                    "1 trace of 'map' repeats an earlier one and is dropped, the first at (0, 7); "
                    "the joint material of it is another one, and that of the earlier holds"));
    EXPECT_THAT(model.repeated_names, ElementsAre("scan"));
}

TEST(RepeatedTraces, OfWhichNoneIsLeftAreNoJointsToEndOn) {
    const std::string text =
        "[domain]\noutline = [[0, 0], [9, 0], [9, 9]]\nblock_material = 'rock'\n"
        "[[traces]]\njoint_material = 'a'\npoints = [[0, 0], [9, 5]]\n"
        "[[traces]]\njoint_material = 'b'\npoints = [[9, 5], [0, 0]]\n"
        "[[joint_set]]\nname = 's'\nangle = '80 deg'\n";
    EXPECT_THAT(
        error_of([&] { slope(text + "kind = 'cross-jointed'\nspacing = 2\nends_on = 'b'\n"); }),
        HasSubstr("slope.toml:15:11: all traces 'b' repeat earlier ones and are dropped; expected the "
                  "name of the traces that they repeat"));
    EXPECT_THAT(error_of([&] {
                    slope(text + "kind = 'baecher'\ntrace_length = 2\np21 = 2\nconditioned_on = 'b'\n");
                }),
                HasSubstr("all traces 'b' repeat earlier ones"));
    EXPECT_EQ(error_of([&] { slope(text + "kind = 'cross-jointed'\nspacing = 2\nends_on = 'a'\n"); }),
              "no error");
}

}  // namespace
}  // namespace rockslope::blockgen::repeated_traces_test
