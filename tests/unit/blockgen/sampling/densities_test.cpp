#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blockgen/sampling/rock_domain.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::densities_test {
namespace {

/// A notched section with a tunnel, so that areas and lengths must exclude cavities.
const std::string head =
    "seed = 1\n[domain]\noutline = [[0, 0], [60, 0], [60, 15], [30, 40], [0, 40]]\nblock_material = "
    "\"rock\"\n"
    "[section]\nazimuth = \"90 deg\"\n"
    "[[tunnel]]\nshape = \"polygon\"\npolygon = [[10, 10], [18, 10], [18, 18], [10, 18]]\n"
    "[[region]]\nname = \"left\"\nblock_material = \"rock\"\npolygon = [[-5, -5], [25, -5], [25, 50], [-5, "
    "50]]\n"
    "[[joint_set]]\nname = \"set\"\n";

struct Densities {
    double p10 = 0, p20 = 0, p21 = 0;
};

/// Densities of the traces before noding. @param u the set's mean direction.
Densities densities_of(const std::vector<Trace>& traces, const RockDomain& rock, const Point& u) {
    Densities sums;
    for (const Trace& t : traces) {
        const Point &a = t.points[0], &b = t.points[1];
        const double length = std::hypot(b.x - a.x, b.y - a.y), in_rock = rock.length_in(a, b);
        sums.p21 += in_rock;
        sums.p10 += in_rock * std::abs((b.x - a.x) * u.x + (b.y - a.y) * u.y) / length;
        sums.p20 += rock.contains({(a.x + b.x) / 2, (a.y + b.y) / 2});
    }
    return {sums.p10 / rock.area(), sums.p20 / rock.area(), sums.p21 / rock.area()};
}

/// Mean over independent seeds.
class SeedMean {
  public:
    void add(double value) {
        ++n_;
        sum_ += value;
        squares_ += value * value;
    }
    double mean() const { return sum_ / n_; }
    double standard_error() const {
        return std::sqrt(std::max(squares_ / n_ - mean() * mean(), 0.0) / (n_ - 1));
    }

  private:
    double n_ = 0, sum_ = 0, squares_ = 0;
};

/// Expects the densities of a model's last set, 0 for those not checked, within three standard errors over
/// that many seeds.
void expect_densities(const std::string& keys, const Densities& expected, std::uint64_t seeds) {
    SlopeModel model = slope(head + keys);
    const JointSet& set = model.joint_sets.back();
    const RockDomain rock(model, set.region);
    const double mean = set.kind == SetKind::voronoi ? 0 : set.orientation.mean_angle();
    SeedMean p10, p20, p21;
    for (model.seed = 1; model.seed <= seeds; ++model.seed) {
        std::vector<Trace> traces = all_traces(model);
        std::erase_if(traces, [&](const Trace& t) { return t.name != set.name; });
        const Densities d = densities_of(traces, rock, {std::cos(mean), std::sin(mean)});
        p10.add(d.p10), p20.add(d.p20), p21.add(d.p21);
    }
    // A stop rule is met to within half a trace.
    const double rounding = set.stop.measure == StopRule::Measure::p20 ? 0.5 / rock.area() : 1e-9;
    const auto check = [&](const char* what, const SeedMean& achieved, double target) {
        if (target <= 0) return;
        const double error = achieved.standard_error();
        EXPECT_NEAR(achieved.mean(), target, 3 * error + rounding)
            << what << " with a standard error of " << error << ", z = " << (achieved.mean() - target) / error
            << ", of\n"
            << keys;
        // With a larger error the comparison would be meaningless.
        EXPECT_LT(error, 0.02 * target) << what << " of\n" << keys;
    };
    check("P10", p10, expected.p10);
    check("P20", p20, expected.p20);
    check("P21", p21, expected.p21);
}

/// The mean of 1 / cos over angles that are uniform within plus and minus `turn`.
double mean_secant(double turn) {
    return std::log(1 / std::cos(turn) + std::tan(turn)) / turn;
}

constexpr double degree = std::numbers::pi / 180;
const std::string within_30 = "angle = { law = \"uniform\", min = \"-10 deg\", max = \"50 deg\" }\n",
                  within_75 = "angle = { law = \"uniform\", min = \"-55 deg\", max = \"95 deg\" }\n",
                  normal_15 = "angle = { law = \"normal\", mean = \"20 deg\", sd = \"15 deg\" }\n",
                  normal_30 = "angle = { law = \"normal\", mean = \"20 deg\", sd = \"30 deg\" }\n",
                  all_round = "angle = { law = \"uniform\", min = \"0 deg\", max = \"180 deg\" }\n",
                  exponential_4 = "trace_length = { law = \"exponential\", mean = 4 }\n";

// Lines with independent directions that cross a scanline at a spacing s cross every parallel scanline at the
// same frequency: P10 = 1 / s. P21 is P10 times the mean of 1 / cos of the angle to the mean direction.
TEST(Densities, OfParallelSets) {
    expect_densities("angle = \"20 deg\"\nspacing = 2\n", {0.5, 0, 0.5}, 1000);
    expect_densities(within_30 + "spacing = 2\n", {0.5, 0, 0.5 * mean_secant(30 * degree)}, 1000);
    expect_densities(within_30 + "spacing = { law = \"exponential\", mean = 1 }\n",
                     {1, 0, mean_secant(30 * degree)}, 1000);
    expect_densities(normal_15 + "spacing = { law = \"lognormal\", mean = 1, sd = 0.4, min = 0.5 }\n",
                     {1 / Distribution{Law::lognormal, 1, 0.4, 0.5}.truncated_mean(), 0, 0}, 1000);
    expect_densities(normal_30 + "spacing = 2\n", {0.5, 0, 0}, 1000);
    expect_densities(within_75 + "spacing = 1\n", {1, 0, mean_secant(75 * degree)}, 2000);
    expect_densities(within_30 + "spacing = 1\nregion = \"left\"\n", {1, 0, mean_secant(30 * degree)}, 1000);
    expect_densities(normal_30 + "spacing = 2\norigin = [31, 22]\n", {0.5, 0, 0}, 1000);
    expect_densities(normal_15 + "spacing = 2\norigin = [-300, 900]\n", {0.5, 0, 0}, 1000);
}

TEST(Densities, OfParallelSetsOfTraces) {
    // Traces of 4 m and bridges of 2 m.
    expect_densities("angle = \"20 deg\"\nspacing = 1\npersistence = 0.666666666666667\n" + exponential_4,
                     {2.0 / 3, 1.0 / 6, 2.0 / 3}, 1000);
    const double secant = mean_secant(30 * degree);
    expect_densities(within_30 + "spacing = 1\ngap = { law = \"exponential\", mean = 2 }\n" + exponential_4,
                     {2.0 / 3, secant / 6, secant * 2 / 3}, 1000);
    // Truncated spacings and traces.
    const double open = Distribution{Law::exponential, 4, 0, 2, 6}.truncated_mean();
    expect_densities(within_30 +
                         "spacing = { law = \"normal\", mean = 1, sd = 0.5, min = 0.5, max = 1.5 }\ngap = 2\n"
                         "trace_length = { law = \"exponential\", mean = 4, min = 2, max = 6 }\n",
                     {open / (open + 2), secant / (open + 2), secant * open / (open + 2)}, 1000);
}

TEST(Densities, OfPlanesInSpace) {
    const double seen = std::sqrt(1 - std::pow(std::sin(60 * degree) * std::sin(30 * degree), 2));
    const std::string plane = "dip = \"60 deg\"\ndip_direction = \"120 deg\"\nspacing = 2\n";
    expect_densities(plane, {seen / 2, 0, seen / 2}, 1000);
    for (const char* k : {"30", "10", "5"})
        expect_densities(plane + "fisher_k = " + k + "\n", {seen / 2, 0, 0}, 2000);
    // Measured planes that strike perpendicular to the section, 15 degrees to either side of the mean.
    expect_densities(
        "orientations = [[\"45 deg\", \"90 deg\"], [\"75 deg\", \"90 deg\"], [\"60 deg\", \"90 deg\"]]\n"
        "spacing = 2\n",
        {0.5, 0, 0.5 * (1 + 2 / std::cos(15 * degree)) / 3}, 1000);
}

// The stop rule is met in each realisation; the other densities follow from the laws of length and angle.
TEST(Densities, OfBaechersTraces) {
    const double cosine = 2 / std::numbers::pi, area = 60 * 40 - 25 * 15 - 64;
    const std::string keys = "kind = \"baecher\"\n" + all_round + exponential_4;
    expect_densities(keys + "p21 = 1\n", {cosine, 0.25, 1}, 300);
    expect_densities(keys + "p20 = 0.25\n", {cosine, 0.25, 1}, 300);
    expect_densities(keys + "count = 490\n", {cosine * 4 * 490 / area, 490 / area, 4 * 490 / area}, 300);
    expect_densities(keys + "p10 = 0.5\n", {0.5, 0.125 / cosine, 0.5 / cosine}, 300);
    expect_densities(keys + "p21 = 1\nregion = \"left\"\n", {cosine, 0, 1}, 300);
    const double thirty = std::sin(30 * degree) / (30 * degree);
    expect_densities("kind = \"baecher\"\np10 = 0.5\n" + within_30 + exponential_4,
                     {0.5, 0.125 / thirty, 0.5 / thirty}, 300);
}

TEST(Densities, OfVenezianosLines) {
    const double cosine = 2 / std::numbers::pi, thirty = std::sin(30 * degree) / (30 * degree);
    const std::string traces = exponential_4 + "persistence = 0.6\n";
    expect_densities("kind = \"veneziano\"\np21 = 1\n" + all_round + traces, {cosine, 0.25, 1}, 600);
    expect_densities("kind = \"veneziano\"\np10 = 0.5\n" + all_round + traces,
                     {0.5, 0.125 / cosine, 0.5 / cosine}, 600);
    expect_densities("kind = \"veneziano\"\np10 = 0.5\n" + within_30 + traces,
                     {0.5, 0.125 / thirty, 0.5 / thirty}, 600);
    expect_densities("kind = \"veneziano\"\np21 = 1\n" + within_30, {thirty, 0, 1}, 600);
}

TEST(Densities, OfCrossJoints) {
    // Beds of 2 m through the whole section; each piece is offset by up to half a spacing.
    const std::string beds =
        "angle = \"0 deg\"\nspacing = 2\norigin = [0, 1]\n[[joint_set]]\nname = \"cross\"\n"
        "kind = \"cross-jointed\"\nends_on = \"set\"\n";
    const double secant = mean_secant(20 * degree);
    expect_densities(beds + "angle = \"80 deg\"\nspacing = 1.5\n", {1 / 1.5, 0, 1 / 1.5}, 300);
    expect_densities(beds + "angle = \"80 deg\"\nspacing = 1.5\ntermination = 0.4\n", {1 / 1.5, 0, 1 / 1.5},
                     300);
    expect_densities(
        beds + "angle = { law = \"uniform\", min = \"60 deg\", max = \"100 deg\" }\nspacing = 1.5\n",
        {1 / 1.5, 0, secant / 1.5}, 300);
}

// Poisson-Voronoi cells: edge length per area 2 sqrt(density), three edges per cell (Meijering 1953).
TEST(Densities, OfVoronoiCells) {
    const double density = 500 / (60.0 * 40 - 25 * 15 - 64);
    expect_densities("kind = \"voronoi\"\ncount = 500\n", {0, 3 * density, 2 * std::sqrt(density)}, 100);
}

// The report measures the noded joints; the targets follow from spacing and stop rule.
TEST(Densities, OfTheReport) {
    for (const std::string& keys :
         {"kind = \"veneziano\"\np10 = 0.5\npersistence = 0.6\n" + all_round + exponential_4,
          "kind = \"baecher\"\np21 = 0.7\n" + all_round + exponential_4,
          normal_30 + "spacing = 2\n" + exponential_4 + "gap = 2\n"}) {
        const SlopeModel model = slope(head + keys);
        const JointSet& set = model.joint_sets[0];
        const double mean = set.orientation.mean_angle();
        const Densities d =
            densities_of(all_traces(model), RockDomain(model, ""), {std::cos(mean), std::sin(mean)});
        const JointBalance b = cut(model).report.joints[0];
        EXPECT_NEAR(b.p10, d.p10, 1e-5 * d.p10) << keys;
        EXPECT_NEAR(b.p20, d.p20, 1e-8 * d.p20) << keys;  // outlines on the grid
        EXPECT_NEAR(b.p21, d.p21, 1e-5 * d.p21) << keys;
        const bool by_p21 = set.stop.measure == StopRule::Measure::p21;
        EXPECT_NEAR(b.p10_target, by_p21 ? 0 : set.kind == SetKind::parallel ? 1.0 / 3 : 0.5, 1e-12) << keys;
        EXPECT_EQ(b.p21_target, by_p21 ? 0.7 : 0) << keys;
    }
    const JointBalance flat =
        cut(slope(head + "angle = \"20 deg\"\nspacing = 2\norigin = [3, 4]\n")).report.joints[0];
    EXPECT_EQ(flat.p10_target, 0.5);
    EXPECT_EQ(flat.p21_target, 0.5);
    const JointBalance cross = cut(slope(head +
                                         "angle = \"20 deg\"\nspacing = 2\n[[joint_set]]\nname = "
                                         "\"cross\"\nkind = \"cross-jointed\"\nends_on = \"set\"\n" +
                                         "spacing = 4\n" + normal_15))
                                   .report.joints[1];
    EXPECT_EQ(cross.p10_target, 0.25);
    EXPECT_EQ(cross.p21_target, 0);
}

}  // namespace
}  // namespace rockslope::blockgen::densities_test
