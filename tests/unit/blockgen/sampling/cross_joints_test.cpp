#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blockgen/sampling/trace_index.hpp"
#include "common/base/input_error.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::cross_joints_test {
namespace {

const std::string bedded = R"(
seed = 3
[domain]
outline = [[0, 0], [60, 0], [60, 40], [0, 40]]
block_material = "rock"
[[joint_set]]
name = "bedding"
angle = "0 deg"
spacing = 2
origin = [0, 1]
[[joint_set]]
name = "cross"
kind = "cross-jointed"
ends_on = "bedding"
angle = "80 deg"
spacing = 3
)";

std::vector<Trace> cross_joints(const SlopeModel& model) {
    std::vector<Trace> result;
    for (const Trace& t : all_traces(model))
        if (t.name == "cross") result.push_back(t);
    return result;
}

TEST(CrossJoints, EndOnTheBedding) {
    const SlopeModel model = slope(bedded);
    const auto traces = cross_joints(model);
    EXPECT_GT(traces.size(), 19u * 18u);
    std::size_t inside = 0;
    for (const Trace& t : traces) {
        for (const Point& p : t.points) {
            const bool is_inside = p.y > 1e-9 && p.y < 40 - 1e-9 && p.x > 1e-9 && p.x < 60 - 1e-9;
            if (!is_inside) continue;
            ++inside;
            EXPECT_NEAR(std::remainder(p.y - 1, 2), 0, 1e-9);
        }
    }
    EXPECT_GT(inside, traces.size()) << "most joints have both ends inside";
    // Each cross joint separates two blocks of one bed, so no joint is pruned.
    const CutResult result = cut(model);
    EXPECT_LT(result.report.joints[1].pruned, 1e-6 * result.report.joints[1].retained);
    EXPECT_EQ(result.report.topology.nodes.i, 0u);
    EXPECT_EQ(result.report.slivers, 0u);
}

TEST(CrossJoints, PiecesAreOffsetLaterally) {
    SlopeModel model = slope(bedded);
    const double across = std::sin(80 * std::numbers::pi / 180);
    const auto offset = [&](const Trace& t) {
        return std::remainder(
            (t.points[0].x * across - t.points[0].y * std::cos(80 * std::numbers::pi / 180)), 3);
    };
    int aside = 0;
    const auto traces = cross_joints(model);
    for (const Trace& t : traces) aside += std::abs(std::remainder(offset(t) - offset(traces[0]), 3)) > 0.1;
    EXPECT_GT(aside, static_cast<int>(traces.size()) * 8 / 10);
    model.joint_sets[1].stagger = 0;
    const auto straight = cross_joints(model);
    for (const Trace& t : straight) EXPECT_NEAR(std::remainder(offset(t) - offset(straight[0]), 3), 0, 1e-6);
}

TEST(CrossJoints, EndWithTheGivenProbability) {
    SlopeModel model = slope(bedded);
    const std::size_t all = cross_joints(model).size();
    model.joint_sets[1].termination = 0;
    const std::size_t none = cross_joints(model).size();
    model.joint_sets[1].termination = 0.4;
    const auto some = static_cast<double>(cross_joints(model).size());
    // Each of all - none intersections ends a piece with probability 0.4: three standard deviations.
    const auto intersections = static_cast<double>(all - none);
    EXPECT_NEAR((some - static_cast<double>(none)) / intersections, 0.4, 3 * std::sqrt(0.24 / intersections));
}

TEST(CrossJoints, KeysOfTheModelFile) {
    const JointSet set = slope(bedded + "termination = 0.7\nstagger = 0.1\n").joint_sets[1];
    EXPECT_EQ(set.termination, 0.7);
    EXPECT_EQ(set.stagger, 0.1);
    for (const char* bad : {"termination = 1.1", "termination = -0.1", "stagger = 2", "persistence = 0.5"})
        EXPECT_THROW(slope(bedded + bad + "\n"), InputError) << bad;
    std::string wrong = bedded;
    wrong.replace(wrong.find("ends_on = \"bedding\""), 19, "ends_on = \"bedd\"");
    EXPECT_THROW(slope(wrong), InputError);
}

TEST(TraceIndex, FindsWhatBruteForceFinds) {
    SlopeModel model = rectangle(10, 10);
    for (int k = 0; k < 300; ++k)
        add_trace(model,
                  {{std::fmod(3.7 * k, 10), std::fmod(1.3 * k, 10)},
                   {std::fmod(3.7 * k + 0.1 * (k % 17), 10), std::fmod(1.3 * k + 0.07 * (k % 29), 10)}});
    const TraceIndex finder(model.traces, Bounds::of(model.outline));
    for (int q = 0; q < 50; ++q) {
        const double angle = 0.13 * q;
        const Point p{5, std::fmod(0.7 * q, 10)}, u{std::cos(angle), std::sin(angle)};
        std::size_t expected = 0;
        const auto inside = Bounds::of(model.outline).clip(p, u);
        for (const Trace& t : model.traces) {
            const Point &a = t.points[0], &b = t.points[1];
            const double d = u.x * (b.y - a.y) - u.y * (b.x - a.x);
            if (d == 0) continue;
            const double along = ((a.x - p.x) * (b.y - a.y) - (a.y - p.y) * (b.x - a.x)) / d;
            const double s = ((a.x - p.x) * u.y - (a.y - p.y) * u.x) / d;
            expected += along >= inside->first && along <= inside->second && s >= 0 && s <= 1;
        }
        EXPECT_EQ(finder.intersections(p, u, inside->first, inside->second).size(), expected) << q;
    }
}

}  // namespace
}  // namespace rockslope::blockgen::cross_joints_test
