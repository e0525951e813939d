#include "blockgen/sampling/sample_joints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/sampling/random_stream.hpp"
#include "blockgen/sampling/rock_domain.hpp"
#include "unit/blockgen/slopes.hpp"
#include "unit/blockgen/statistics.hpp"

namespace rockslope::blockgen::sample_joints_test {
namespace {

constexpr int draws = 10000;

std::vector<double> sample(const Distribution& d) {
    const RandomStream stream(1, "test");
    std::vector<double> values;
    for (int k = 0; k < draws; ++k)
        values.push_back(d.quantile(stream.draw(0, 0, static_cast<std::uint64_t>(k))));
    std::sort(values.begin(), values.end());
    return values;
}

/// The limit that a sample exceeds with probability 1e-3.
const double limit = ks_limit(draws);

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

double normal(double z) {
    return std::erfc(-z / std::numbers::sqrt2) / 2;
}

TEST(Distribution, FollowsItsLaw) {
    EXPECT_EQ(mean_of(sample(constant_value(3))), 3);

    const auto uniform = sample({Law::uniform, 0, 0, 2, 5});
    EXPECT_LT(ks_distance(uniform, [](double x) { return (x - 2) / 3; }), limit);
    EXPECT_NEAR(mean_of(uniform), 3.5, 4 * 3 / std::sqrt(12.0 * draws));

    Distribution d{Law::normal, 10, 2};
    EXPECT_LT(ks_distance(sample(d), [](double x) { return normal((x - 10) / 2); }), limit);
    EXPECT_NEAR(mean_of(sample(d)), 10, 4 * 2 / std::sqrt(draws));

    d = {Law::lognormal, 3, 0.6};
    const double s = std::sqrt(std::log(1.04)), m = std::log(3) - s * s / 2;
    EXPECT_LT(ks_distance(sample(d), [&](double x) { return normal((std::log(x) - m) / s); }), limit);
    EXPECT_NEAR(mean_of(sample(d)), 3, 4 * 0.6 / std::sqrt(draws));

    d = {Law::exponential, 20};
    EXPECT_LT(ks_distance(sample(d), [](double x) { return 1 - std::exp(-x / 20); }), limit);
    EXPECT_NEAR(mean_of(sample(d)), 20, 4 * 20 / std::sqrt(draws));
}

TEST(Distribution, TruncationKeepsTheShapeWithin) {
    const Distribution d{Law::exponential, 20, 0, 5, 30};
    const auto values = sample(d);
    EXPECT_GE(values.front(), 5);
    EXPECT_LE(values.back(), 30);
    const double low = std::exp(-0.25), high = std::exp(-1.5);
    EXPECT_LT(ks_distance(values, [&](double x) { return (low - std::exp(-x / 20)) / (low - high); }), limit);
    for (const auto& [from, to] : {std::pair(9.0, 9.5), std::pair(7.0, 12.0), std::pair(14.0, 30.0)}) {
        const double below = normal((from - 10) / 2), within = normal((to - 10) / 2) - below;
        EXPECT_LT(ks_distance(sample({Law::normal, 10, 2, from, to}),
                              [&](double x) { return (normal((x - 10) / 2) - below) / within; }),
                  limit)
            << from;
    }
    const double s = std::sqrt(std::log(1.04)), m = std::log(3) - s * s / 2;
    const auto lognormal = [&](double x) { return normal((std::log(x) - m) / s); };
    EXPECT_LT(ks_distance(sample({Law::lognormal, 3, 0.6, 2.5, 4}),
                          [&](double x) {
                              return (lognormal(x) - lognormal(2.5)) / (lognormal(4) - lognormal(2.5));
                          }),
              limit);
    const auto narrow = sample({Law::normal, 10, 2, 9, 9.5});
    EXPECT_GE(narrow.front(), 9);
    EXPECT_LE(narrow.back(), 9.5);
}

TEST(RandomStream, GivesTheSameNumbersOnEveryPlatform) {
    // Recorded values: a change would change the result of every seed.
    const RandomStream stream(42, "bedding");
    EXPECT_EQ(stream.draw(0, 0, 0), 0.053038580676637692);
    EXPECT_EQ(stream.draw(3, -7, 11), 0.25809822305966346);
    EXPECT_NE(stream.draw(0, 0, 0), RandomStream(43, "bedding").draw(0, 0, 0));
    EXPECT_NE(stream.draw(0, 0, 0), RandomStream(42, "Bedding").draw(0, 0, 0));
}

JointSet parallel(double angle_degrees, double spacing) {
    JointSet set;
    set.name = set.joint_material = "set";
    set.orientation.angle = constant_value(angle_degrees * std::numbers::pi / 180);
    set.spacing = constant_value(spacing);
    return set;
}

TEST(SampleJoints, ConstantSpacingFillsTheDomain) {
    const SlopeModel model = rectangle(100, 50);
    JointSet set = parallel(90, 2);
    set.origin = Point{1, 0};
    const std::vector<Trace> traces = sample_joint_set(set, model);
    EXPECT_EQ(traces.size(), 50u);
    for (const Trace& trace : traces)
        EXPECT_NEAR(std::hypot(trace.points[1].x - trace.points[0].x, trace.points[1].y - trace.points[0].y),
                    50, 1e-9);
}

TEST(SampleJoints, TheOriginIsOnAJointWhereverItLies) {
    for (const Point origin : {Point{3, 4}, Point{-500, 70}, Point{1000, 1000}}) {
        JointSet set = parallel(-25, 3);
        set.origin = origin;
        const auto traces = sample_joint_set(set, rectangle(100, 50));
        EXPECT_GT(traces.size(), 20u);
        const double a = -25 * std::numbers::pi / 180;
        for (const Trace& t : traces) {
            const double offset =
                -(t.points[0].x - origin.x) * std::sin(a) + (t.points[0].y - origin.y) * std::cos(a);
            EXPECT_NEAR(std::remainder(offset, 3), 0, 1e-9);
        }
    }
}

TEST(SampleJoints, TheOriginIsOnAJointWhereAnglesScatter) {
    SlopeModel model = rectangle(100, 50);
    JointSet set = parallel(-25, 3);
    set.orientation.angle = {Law::normal, -0.4, 0.3};
    set.origin = Point{80, 11};
    for (model.seed = 1; model.seed <= 20; ++model.seed) {
        double nearest = 1e9;
        for (const Trace& t : sample_joint_set(set, model)) {
            const Point &a = t.points[0], &b = t.points[1];
            const double twice_area = (b.x - a.x) * (11 - a.y) - (b.y - a.y) * (80 - a.x);
            nearest = std::min(nearest, std::abs(twice_area) / std::hypot(b.x - a.x, b.y - a.y));
        }
        EXPECT_LT(nearest, 1e-12) << model.seed;
    }
}

// Traces are not clipped, so that a trace is counted only when its midpoint lies in the rock.
TEST(SampleJoints, TracesAreNotClippedAtTheBoundary) {
    JointSet set = parallel(90, 1);
    set.trace_length = constant_value(7);
    set.gap = constant_value(1);
    const auto traces = sample_joint_set(set, rectangle(100, 20));
    EXPECT_GT(traces.size(), 200u);
    for (const Trace& t : traces) EXPECT_NEAR(std::abs(t.points[1].y - t.points[0].y), 7, 1e-9);
}

TEST(SampleJoints, TracesAndGapsAlternate) {
    JointSet set = parallel(30, 0.5);
    set.trace_length = Distribution{Law::exponential, 4};
    set.gap = Distribution{Law::uniform, 0, 0, 0.5, 1.5};
    const SlopeModel model = rectangle(100, 100);
    const RockDomain rock(model, "");
    double length = 0;
    for (const Trace& t : sample_joint_set(set, model)) length += rock.length_in(t.points[0], t.points[1]);
    // The persistence is four fifths, within three standard errors. For a renewal process of traces (mean and
    // standard deviation 4) and bridges (mean 1, standard deviation 1 / sqrt(12)) the variance of the trace
    // length on a line of length l is (16 + 16 / 12) / 5^3 l.
    set.trace_length.reset();
    double whole = 0;
    for (const Trace& t : sample_joint_set(set, model)) whole += rock.length_in(t.points[0], t.points[1]);
    EXPECT_NEAR(length / whole, 0.8, 3 * std::sqrt((16 + 16 / 12.0) / 125 / whole));
}

// The domain is ten spacings wide, so one joint too many at its boundary would be an error of 10 %. The
// frequency must not depend on the first joint, for any law: within 3.5 standard errors of 1000 seeds.
TEST(SampleJoints, SpacingsGiveTheirFrequencyWithoutEdgeEffects) {
    constexpr int seeds = 1000;
    SlopeModel model = rectangle(50, 20);
    for (const Distribution& spacing :
         {constant_value(2), Distribution{Law::uniform, 0, 0, 1, 3}, Distribution{Law::exponential, 2},
          Distribution{Law::lognormal, 2, 0.5}, Distribution{Law::gamma, 2, 3}}) {
        JointSet set = parallel(0, 1);
        set.spacing = spacing;
        const std::array<std::pair<double, double>, 3> windows = {{{0, 20}, {0, 2}, {18, 20}}};
        std::array<double, 3> sums{}, squares{};
        for (model.seed = 1; model.seed <= seeds; ++model.seed) {
            const std::vector<Trace> traces = sample_joint_set(set, model);
            for (std::size_t w = 0; w < windows.size(); ++w) {
                const auto met =
                    static_cast<double>(std::count_if(traces.begin(), traces.end(), [&](const Trace& t) {
                        return t.points[0].y >= windows[w].first && t.points[0].y < windows[w].second;
                    }));
                sums[w] += met;
                squares[w] += met * met;
            }
        }
        for (std::size_t w = 0; w < windows.size(); ++w) {
            const double mean = sums[w] / seeds, expected = (windows[w].second - windows[w].first) / 2;
            const double error = std::sqrt((squares[w] / seeds - mean * mean) / seeds);
            EXPECT_NEAR(mean, expected, 3.5 * error + 1e-9) << static_cast<int>(spacing.law) << ' ' << w;
        }
    }
}

TEST(SampleJoints, ARegionLimitsItsSet) {
    SlopeModel model = rectangle(10, 10);
    model.regions = {{"left", "rock", "", {{-1, -1}, {5, -1}, {5, 11}, {-1, 11}}, {}}};
    JointSet set = parallel(0, 1);
    set.region = "left";
    const auto traces = sample_joint_set(set, model);
    EXPECT_NEAR(static_cast<double>(traces.size()), 12, 1) << "one for each metre of the region's height";
    for (const Trace& t : traces) {
        const auto [low, high] = std::minmax(t.points.front().x, t.points.back().x);
        EXPECT_EQ(low, -1) << "the cut ends them at the outline";
        EXPECT_EQ(high, 5);
    }
}

const char* two_sets = R"(
seed = 42
[domain]
outline = [[0, 0], [40, 0], [40, 30], [0, 30]]
block_material = "rock"
[[joint_set]]
name = "bedding"
angle = "-25 deg"
spacing = { law = "lognormal", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }
[[joint_set]]
name = "cross"
angle = { law = "normal", mean = "65 deg", sd = "4 deg" }
spacing = { law = "exponential", mean = 3.0, min = 0.5 }
trace_length = { law = "exponential", mean = 12 }
gap = 1
)";

TEST(SampleJoints, TheSameSeedGivesTheSameBytes) {
    const std::string first = block_file_text(cut(slope(two_sets)).mesh);
    EXPECT_EQ(first, block_file_text(cut(slope(two_sets)).mesh));
    std::string other = two_sets;
    other.replace(other.find("42"), 2, "43");
    EXPECT_NE(first, block_file_text(cut(slope(other)).mesh));
}

TEST(SampleJoints, EditingOneSetDoesNotChangeTheOther) {
    SlopeModel model = slope(two_sets);
    const auto before = sample_joint_set(model.joint_sets[1], model);
    model.joint_sets[0].spacing = constant_value(1);
    std::swap(model.joint_sets[0], model.joint_sets[1]);
    const auto after = sample_joint_set(model.joint_sets[0], model);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k) EXPECT_EQ(before[k].points, after[k].points);
}

/// One set of each kind; the Voronoi cells are limited to a region.
const std::string all_kinds = R"(
seed = 42
[domain]
outline = [[0, 0], [40, 0], [40, 30], [0, 30]]
block_material = "rock"
[[region]]
name = "left"
block_material = "rock"
polygon = [[-1, -1], [15, 2], [12, 31], [-1, 31]]
[[joint_set]]
name = "parallel"
angle = { law = "normal", mean = "65 deg", sd = "9 deg" }
spacing = 3
[[joint_set]]
name = "cross"
kind = "cross-jointed"
ends_on = "parallel"
angle = "-20 deg"
spacing = 3
[[joint_set]]
name = "baecher"
kind = "baecher"
angle = { law = "uniform", min = "0 deg", max = "90 deg" }
trace_length = { law = "exponential", mean = 4 }
p21 = 0.3
[[joint_set]]
name = "veneziano"
kind = "veneziano"
angle = { law = "uniform", min = "0 deg", max = "90 deg" }
trace_length = { law = "exponential", mean = 4 }
persistence = 0.5
p21 = 0.3
[[joint_set]]
name = "cells"
kind = "voronoi"
region = "left"
count = 30
)";

TEST(SampleJoints, AddingOrRemovingASetDoesNotChangeTheOthers) {
    const SlopeModel model = slope(all_kinds);
    const auto of_set = [](const std::vector<Trace>& traces, const std::string& name) {
        std::vector<std::vector<Point>> points;
        for (const Trace& t : traces)
            if (t.name == name) points.push_back(t.points);
        return points;
    };
    const auto before = all_traces(model);
    for (const auto& place : {0, 2, 5}) {
        SlopeModel more = model;
        JointSet extra = parallel(10, 0.7);
        extra.name = "extra";
        more.joint_sets.insert(more.joint_sets.begin() + place, extra);
        const auto after = all_traces(more);
        EXPECT_GT(of_set(after, "extra").size(), 40u);
        for (const JointSet& set : model.joint_sets)
            EXPECT_EQ(of_set(before, set.name), of_set(after, set.name)) << set.name << ' ' << place;
    }
    for (std::size_t gone = 1; gone < 5; ++gone) {  // the second set ends on the first
        SlopeModel less = model;
        less.joint_sets.erase(less.joint_sets.begin() + static_cast<std::ptrdiff_t>(gone));
        const auto after = all_traces(less);
        for (const JointSet& set : less.joint_sets)
            EXPECT_EQ(of_set(before, set.name), of_set(after, set.name)) << set.name << ' ' << gone;
    }
}

TEST(SampleJoints, EveryKindStaysInItsRegion) {
    SlopeModel model = slope(all_kinds);
    for (JointSet& set : model.joint_sets) set.region = "left";
    const RockDomain left(model, "left");
    double length = 0;
    for (const Trace& t : all_traces(model)) {
        const Point &a = t.points[0], &b = t.points[1];
        const auto pieces = left.pieces_in_region(a, b);
        double within = 0;
        for (const auto& [p, q] : pieces) within += std::hypot(q.x - p.x, q.y - p.y);
        EXPECT_NEAR(within, std::hypot(b.x - a.x, b.y - a.y), 1e-9) << t.name;
        length += within;
    }
    EXPECT_GT(length, 500);
    EXPECT_TRUE(cut(model).report.verified);
}

TEST(SampleJoints, TooManyLinesAreRefused) {
    EXPECT_THROW(sample_joint_set(parallel(10, 0.01), rectangle(100, 100), {}, {.max_blocks = 0}),
                 InputError);
    // Lines outside the domain take as much time as those inside.
    JointSet set = parallel(10, 0.01);
    set.origin = Point{1e9, 1e9};
    EXPECT_THROW(sample_joint_set(set, rectangle(1, 1), {}, {.max_blocks = 0}), InputError);
}

// Lengths this small do not change the position along the line, so the loop would not end.
TEST(SampleJoints, TooManyTracesAreRefused) {
    for (const auto& [length, gap] : {std::pair(1e-3, 0.0), std::pair(1e-9, 1e-9), std::pair(1e-30, 0.0)}) {
        JointSet set = parallel(10, 50);
        set.trace_length = constant_value(length);
        set.gap = constant_value(gap);
        EXPECT_THROW(sample_joint_set(set, rectangle(100, 100), {}, {.max_blocks = 0}), InputError) << length;
    }
}

}  // namespace
}  // namespace rockslope::blockgen::sample_joints_test
