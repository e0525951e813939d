#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blockgen/input/trace_length.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::conditioned_sets_test {
namespace {

using testing::HasSubstr;

/// A square of 20 m with two mapped traces, 30 m long in all, and a set to which they belong.
std::string model_text(const std::string& set) {
    return "seed = 4\n[domain]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\nblock_material = \"rock\"\n"
           "[[traces]]\nname = \"mapped\"\njoint_material = \"j\"\npoints = [[2, 1], [2, 11]]\n"
           "[[traces]]\nname = \"mapped\"\njoint_material = \"j\"\npoints = [[5, 0], [5, 20]]\n"
           "[[joint_set]]\nname = \"set\"\nangle = { law = \"normal\", mean = \"80 deg\", sd = \"8 deg\" "
           "}\n" +
           set;
}

/// Length within the square of the joints of a name.
double length_of_joints(const CutReport& report, const std::string& name) {
    for (const JointBalance& b : report.joints)
        if (b.name == name) return b.retained + b.pruned;
    return 0;
}

TEST(ConditionedSet, AddsToTheMappedTracesUpToItsDensity) {
    const std::string set = "kind = \"baecher\"\ntrace_length = 3\np21 = 0.5\n";
    const CutReport alone = cut(slope(model_text(set))).report;
    const CutReport filled = cut(slope(model_text(set + "conditioned_on = \"mapped\"\n"))).report;
    EXPECT_NEAR(length_of_joints(alone, "set"), 200, 1.6);
    EXPECT_NEAR(length_of_joints(filled, "set") + length_of_joints(filled, "mapped"), 200, 1.6);
    EXPECT_NEAR(length_of_joints(filled, "mapped"), 30, 1e-3);
    // Lines of traces, and a density that the map has already.
    const CutReport lines =
        cut(slope(model_text("kind = \"veneziano\"\ntrace_length = 3\ngap = 1\np21 = 0.5\n"
                             "conditioned_on = \"mapped\"\n")))
            .report;
    EXPECT_NEAR(length_of_joints(lines, "set") + length_of_joints(lines, "mapped"), 200, 12);
    const CutReport full = cut(slope(model_text("kind = \"baecher\"\ntrace_length = 3\np21 = 0.05\n"
                                                "conditioned_on = \"mapped\"\n")))
                               .report;
    EXPECT_EQ(length_of_joints(full, "set"), 0);
}

/// Number of joints of the set beside the map with further mapped traces.
std::size_t sampled_beside(const std::string& set, const std::string& further) {
    std::string text = model_text(set + "conditioned_on = \"mapped\"\n");
    text.insert(text.find("[[joint_set]]"), further);
    const std::vector<Trace> traces = all_traces(slope(text));
    return std::count_if(traces.begin(), traces.end(), [](const Trace& t) { return t.name == "set"; });
}

std::string mapped_trace(const std::string& points) {
    return "[[traces]]\nname = \"mapped\"\njoint_material = \"j\"\npoints = " + points + "\n";
}

TEST(ConditionedSet, CountsMappedTracesThatOverlapOnce) {
    const std::vector<std::string> overlaps = {
        mapped_trace("[[5, 20], [5, 0]]"),                                    // a whole trace again
        mapped_trace("[[5, 4], [5, 14]]"),                                    // half of it
        mapped_trace("[[5, -6], [5, 14]]"),                                   // from outside the rock
        mapped_trace("[[5, 1], [5, 12]]") + mapped_trace("[[5, 8], [5, 3]]")  // three times in part
    };
    for (const char* stop : {"p21 = 0.2\n", "p10 = 0.2\n"})
        for (const char* kind : {"kind = \"baecher\"\ntrace_length = 3\n",
                                 "kind = \"veneziano\"\ntrace_length = 3\ngap = 1\n"}) {
            const std::string set = std::string(kind) + stop;
            const std::size_t once = sampled_beside(set, "");
            EXPECT_GT(once, 10u);
            for (const std::string& further : overlaps)
                EXPECT_EQ(sampled_beside(set, further), once) << set << further;
        }
}

TEST(ConditionedSet, LeavesAMappedAreaAsItIs) {
    const SlopeModel model =
        slope(model_text("kind = \"baecher\"\ntrace_length = 3\np21 = 0.5\nconditioned_on = \"mapped\"\n"
                         "mapped_area = [[-9, -9], [10, -9], [10, 29], [-9, 29]]\n"));
    const std::vector<Trace> traces = all_traces(model);
    double outside = 0;
    std::size_t sampled = 0;
    for (const Trace& trace : traces) {
        if (trace.name != "set") continue;
        ++sampled;
        for (const Point& p : trace.points) EXPECT_GE(p.x, 10 - 1e-9);
        const Bounds rock{{0, 0}, {20, 20}};
        const Point &a = trace.points[0], &b = trace.points[1];
        if (const auto inside = rock.clip(a, {b.x - a.x, b.y - a.y}))
            outside += length_of(trace) *
                       std::max(0.0, std::min(inside->second, 1.0) - std::max(inside->first, 0.0));
    }
    EXPECT_GT(sampled, 20u);
    // Half of the square was not mapped: 200 m2.
    EXPECT_NEAR(outside, 100, 1.6);
}

TEST(ConditionedSet, NeedsTracesOfThatName) {
    const std::string set = "kind = \"baecher\"\ntrace_length = 3\np21 = 0.5\n";
    const auto error = [&](const std::string& keys) {
        return error_of([&] { slope(model_text(set + keys)); });
    };
    EXPECT_THAT(error("conditioned_on = \"faults\"\n"), HasSubstr("no traces 'faults'"));
    EXPECT_THAT(error("mapped_area = [[0, 0], [1, 0], [0, 1]]\n"), HasSubstr("conditioned_on"));
    EXPECT_THAT(error_of([&] { slope(model_text("spacing = 2\nconditioned_on = \"mapped\"\n")); }),
                HasSubstr("conditioned_on"));
}

}  // namespace
}  // namespace rockslope::blockgen::conditioned_sets_test
