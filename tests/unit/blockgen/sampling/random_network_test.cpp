#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blockgen/input/trace_length.hpp"
#include "blockgen/sampling/rock_domain.hpp"
#include "common/base/input_error.hpp"
#include "unit/blockgen/slopes.hpp"
#include "unit/blockgen/statistics.hpp"

namespace rockslope::blockgen::random_network_test {
namespace {

constexpr double degree = std::numbers::pi / 180;
using Measure = StopRule::Measure;

JointSet random_set(SetKind kind, const StopRule& stop) {
    JointSet set;
    set.name = set.joint_material = "set";
    set.kind = kind;
    set.orientation.angle = {Law::uniform, 0, 0, 0, std::numbers::pi};
    set.trace_length = Distribution{Law::exponential, 4};
    set.stop = stop;
    return set;
}

/// A notched section with a tunnel, so that areas and lengths must exclude cavities.
SlopeModel notched() {
    SlopeModel model = rectangle(60, 40);
    model.outline = {{0, 0}, {60, 0}, {60, 15}, {30, 40}, {0, 40}};
    model.tunnels.push_back({"t", {{10, 10}, {18, 10}, {18, 18}, {10, 18}}, {}});
    model.seed = 7;
    return model;
}

double length_in(const RockDomain& rock, const std::vector<Trace>& traces) {
    double length = 0;
    for (const Trace& t : traces) length += rock.length_in(t.points[0], t.points[1]);
    return length;
}

TEST(RockDomain, ExcludesCavities) {
    SlopeModel model = notched();
    const double area = 60 * 40 - 25 * 15 - 64;
    const RockDomain rock(model, "");
    EXPECT_NEAR(rock.area(), area, 1e-9);
    EXPECT_NEAR(rock.length_in({-10, 14}, {70, 14}), 52, 1e-9);
    EXPECT_FALSE(rock.contains({14, 14}));
    EXPECT_TRUE(rock.contains({1, 1}));
    EXPECT_FALSE(rock.contains({59, 39}));
    model.regions.push_back({"left", "rock", "", {{-5, -5}, {14, -5}, {14, 50}, {-5, 50}}, {}});
    const RockDomain left(model, "left");
    EXPECT_NEAR(left.area(), 14 * 40 - 4 * 8, 1e-9);
    EXPECT_NEAR(left.length_in({-10, 14}, {70, 14}), 10, 1e-9);
}

TEST(RockDomain, SubtractsOverlappingCavitiesOnce) {
    SlopeModel model = notched();
    model.tunnels.push_back({"u", {{14, 12}, {22, 12}, {22, 16}, {14, 16}}, {}});
    model.holes.push_back({{15, 13}, {30, 13}, {30, 15}, {15, 15}});
    const RockDomain rock(model, "");
    EXPECT_NEAR(rock.length_in({-10, 14}, {70, 14}), 60 - 20, 1e-9);
    EXPECT_NEAR(rock.length_in({70, 14}, {-10, 14}), 60 - 20, 1e-9);
    EXPECT_NEAR(rock.area(), 60 * 40 - 25 * 15 - 64 - 4 * 4 - 8 * 2, 1e-9);
}

TEST(Baecher, MeetsItsStopRule) {
    const SlopeModel model = notched();
    const RockDomain rock(model, "");
    const auto p21 = sample_joint_set(random_set(SetKind::baecher, {Measure::p21, 0.8}), model);
    // The last trace is kept when that is nearer to the target; the error is at most half a long trace.
    EXPECT_NEAR(length_in(rock, p21) / rock.area(), 0.8, 15 / rock.area());

    const auto middles = [&](const std::vector<Trace>& traces) {
        double n = 0;
        for (const Trace& t : traces)
            n += rock.contains({(t.points[0].x + t.points[1].x) / 2, (t.points[0].y + t.points[1].y) / 2});
        return n;
    };
    EXPECT_EQ(middles(sample_joint_set(random_set(SetKind::baecher, {Measure::count, 300}), model)), 300);
    const auto p20 = sample_joint_set(random_set(SetKind::baecher, {Measure::p20, 0.2}), model);
    EXPECT_NEAR(middles(p20) / rock.area(), 0.2, 0.5 / rock.area() + 1e-12);

    JointSet flat = random_set(SetKind::baecher, {Measure::p10, 0.5});
    flat.orientation.angle = constant_value(20 * degree);
    // With one direction, P10 perpendicular to it equals P21.
    EXPECT_NEAR(length_in(rock, sample_joint_set(flat, model)) / rock.area(), 0.5, 15 / rock.area());
}

TEST(Baecher, FollowsItsLawsWithoutEdgeEffects) {
    SlopeModel model = rectangle(100, 100);
    model.seed = 3;
    const auto traces = sample_joint_set(random_set(SetKind::baecher, {Measure::count, 8000}), model);
    std::vector<double> lengths, angles;
    double inner = 0, outer = 0;
    const RockDomain rock(model, "");
    SlopeModel core = rectangle(50, 50);
    core.outline = {{25, 25}, {75, 25}, {75, 75}, {25, 75}};
    const RockDomain middle(core, "");
    for (const Trace& t : traces) {
        lengths.push_back(length_of(t));
        double angle = std::atan2(t.points[1].y - t.points[0].y, t.points[1].x - t.points[0].x);
        angles.push_back(angle < 0 ? angle + std::numbers::pi : angle);
        inner += middle.length_in(t.points[0], t.points[1]);
        outer += rock.length_in(t.points[0], t.points[1]);
    }
    EXPECT_LT(ks_distance(lengths, [](double x) { return 1 - std::exp(-x / 4); }), ks_limit(lengths.size()));
    EXPECT_LT(ks_distance(angles, [](double a) { return a / std::numbers::pi; }), ks_limit(angles.size()));
    // The density near the boundary equals that in the middle quarter within three standard errors: the total
    // length of n exponential traces has the relative error sqrt(2 / n).
    EXPECT_NEAR(inner / 2500 / ((outer - inner) / 7500), 1, 3 * std::sqrt(2 / 2000.0 + 2 / 6000.0));
}

TEST(Veneziano, LinesHaveTheGivenPersistence) {
    SlopeModel model = rectangle(100, 100);
    model.seed = 11;
    JointSet set = random_set(SetKind::veneziano, {Measure::p21, 1});
    set.gap = Distribution{Law::exponential, 2};
    const auto traces = sample_joint_set(set, model);
    const RockDomain rock(model, "");
    // The last line is kept when that is nearer to the target; the error is at most half of the longest line.
    EXPECT_NEAR(length_in(rock, traces) / rock.area(), 1, 71 / rock.area());

    set.stop = {Measure::count, 400};
    const double open = length_in(rock, sample_joint_set(set, model));
    JointSet whole = set;
    whole.trace_length.reset();
    const auto lines = sample_joint_set(whole, model);
    EXPECT_EQ(lines.size(), 400u);
    const double total = length_in(rock, lines);
    // The persistence is two thirds. For a renewal process of traces (mean and sd 4) and bridges (2) the
    // variance of the trace length on a line of length l is 2 (4 2)^2 / 6^3 l; three standard errors.
    EXPECT_NEAR(open / total, 2.0 / 3, 3 * std::sqrt(2 * 64.0 / 216 / total));
}

TEST(Veneziano, LinesAreUniformlyDistributed) {
    // Uniform isotropic lines intersect the central disc in chords of mean length pi r / 2.
    SlopeModel model = rectangle(100, 100);
    JointSet set = random_set(SetKind::veneziano, {Measure::count, 4000});
    set.trace_length.reset();
    double sum = 0;
    int chords = 0;
    for (const Trace& t : sample_joint_set(set, model)) {
        const Point &a = t.points[0], &b = t.points[1];
        const double d = ((b.x - a.x) * (50 - a.y) - (b.y - a.y) * (50 - a.x)) / length_of(t);
        if (std::abs(d) >= 40) continue;
        sum += 2 * std::sqrt(1600 - d * d);
        ++chords;
    }
    // The standard deviation of the chord length is r sqrt(8/3 - pi^2/4).
    EXPECT_NEAR(sum / chords, std::numbers::pi * 20, 3 * 40 * std::sqrt((8.0 / 3 - 2.4674) / chords));
}

TEST(RandomNetworks, InARegion) {
    SlopeModel model = notched();
    model.regions.push_back({"left", "rock", "", {{-5, -5}, {25, -5}, {25, 50}, {-5, 50}}, {}});
    JointSet set = random_set(SetKind::baecher, {Measure::p21, 1});
    set.region = "left";
    const auto traces = sample_joint_set(set, model);
    const RockDomain rock(model, "left");
    EXPECT_NEAR(length_in(rock, traces) / rock.area(), 1, 15 / rock.area());
    for (const Trace& t : traces)
        for (const Point& p : t.points) EXPECT_LE(p.x, 25 + 1e-9);
    model.joint_sets.push_back(set);
    const CutResult result = cut(model);
    EXPECT_NEAR(result.report.joints[0].p21, 1, 0.03);
    EXPECT_EQ(result.report.joints[0].p21_target, 1);
}

TEST(RandomNetworks, AreReproducible) {
    const SlopeModel model = notched();
    for (const SetKind kind : {SetKind::baecher, SetKind::veneziano}) {
        JointSet set = random_set(kind, {Measure::p21, 0.5});
        set.gap = constant_value(1);
        const auto first = sample_joint_set(set, model), again = sample_joint_set(set, model);
        ASSERT_EQ(first.size(), again.size());
        for (std::size_t k = 0; k < first.size(); ++k) EXPECT_EQ(first[k].points, again[k].points);
        // A higher target continues the sequence of the lower target.
        set.stop.target = 0.8;
        const auto more = sample_joint_set(set, model);
        for (std::size_t k = 0; k + 10 < first.size(); ++k) EXPECT_EQ(first[k].points, more[k].points);
    }
}

const std::string head =
    "seed = 1\n[domain]\noutline = [[0, 0], [20, 0], [20, 10], [0, 10]]\nblock_material = \"rock\"\n"
    "[[joint_set]]\nname = \"a\"\n";

TEST(RandomNetworks, KeysOfTheModelFile) {
    const JointSet b =
        slope(head + "kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 4\np20 = 0.5\n").joint_sets[0];
    EXPECT_EQ(b.kind, SetKind::baecher);
    EXPECT_EQ(b.stop.measure, Measure::p20);
    EXPECT_EQ(b.stop.target, 0.5);
    const JointSet v = slope(head +
                             "kind = \"veneziano\"\nangle = \"3 deg\"\np10 = 1\n"
                             "trace_length = { law = \"exponential\", mean = 6 }\npersistence = 0.75\n")
                           .joint_sets[0];
    EXPECT_EQ(v.gap->law, Law::exponential);
    EXPECT_NEAR(v.gap->mean, 2, 1e-5);
    for (const char* bad : {"kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 4",
                            "kind = \"baecher\"\nangle = \"3 deg\"\np21 = 1",
                            "kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 4\np21 = 0",
                            "kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 4\np21 = 1\ncount = 5",
                            "kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 4\np21 = 1\nspacing = 5",
                            "kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 4\np21 = 1\ngap = 5",
                            "kind = \"veneziano\"\nangle = \"3 deg\"\np20 = 1", "kind = \"baecker\"",
                            "kind = \"parallel\"\nangle = \"3 deg\"\np21 = 1"})
        EXPECT_THROW(slope(head + bad + "\n"), InputError) << bad;
}

TEST(RandomNetworks, PersistenceOfTruncatedTraces) {
    // The bridge follows from the mean of the truncated traces, so that the persistence is the given one.
    const SlopeModel model = slope(head +
                                   "angle = \"30 deg\"\nspacing = 0.02\npersistence = 0.7\n"
                                   "trace_length = { law = \"exponential\", mean = 2, min = 1, max = 4 }\n");
    const auto traces = sample_joint_set(model.joint_sets[0], model);
    JointSet whole = model.joint_sets[0];
    whole.trace_length.reset();
    const RockDomain rock(model, "");
    const double total = length_in(rock, sample_joint_set(whole, model));
    // Traces have the mean 2.16 and a standard deviation below 0.87, bridges are constant, 0.93. The variance
    // of the trace length per length is at most (0.93 0.87)^2 / 3.09^3.
    EXPECT_NEAR(length_in(rock, traces) / total, 0.7,
                3 * std::sqrt(0.93 * 0.93 * 0.87 * 0.87 / 29.5 / total));
}

}  // namespace
}  // namespace rockslope::blockgen::random_network_test
