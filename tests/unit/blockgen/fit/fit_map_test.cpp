// Sets of known statistics, sampled, cut off at the edge of a map, and estimated from it.
#include "blockgen/fit/fit_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::fit_map_test {
namespace {

constexpr int seeds = 40;
constexpr double degree = std::numbers::pi / 180;

/// How 40 estimates compare with the truth.
struct Tally {
    double truth = 0, sum = 0;
    int covering = 0, count = 0;

    void add(const Estimate& e) {
        sum += e.value;
        covering += e.low <= truth && truth <= e.high;
        ++count;
        EXPECT_LE(e.low, e.high);
    }
    double mean() const { return sum / count; }
};

using Tallies = std::map<std::string, Tally>;

/// Adds the estimates of a map to the tallies of its sets, which are in the order of their directions.
void add_fit(const JointMap& map, std::vector<Tallies>& tallies) {
    MapFit fit = fit_map(map, {});
    ASSERT_EQ(fit.sets.size(), tallies.size());
    std::sort(fit.sets.begin(), fit.sets.end(),
              [](const FittedSet& a, const FittedSet& b) { return a.direction.value < b.direction.value; });
    for (std::size_t k = 0; k < tallies.size(); ++k) {
        const FittedSet& set = fit.sets[k];
        const auto add = [&](const char* name, const std::optional<Estimate>& estimate) {
            if (const auto found = tallies[k].find(name); found != tallies[k].end() && estimate)
                found->second.add(*estimate);
        };
        add("direction", set.direction);
        add("scatter", set.scatter);
        add("length", set.length);
        add("length_sd", set.length_sd);
        add("p20", set.p20);
        add("p21", set.p21);
        add("spacing", set.spacing);
        add("spacing_sd", set.spacing_sd);
        add("persistence", set.persistence);
    }
}

const Ring window = {{0, 0}, {40, 0}, {40, 30}, {0, 30}};

/// Samples the sets of a model in the window with many seeds, and fits the maps of them.
std::vector<Tallies> tallies_of(const std::string& sets, std::vector<Tallies> tallies) {
    for (int seed = 1; seed <= seeds; ++seed) {
        const SlopeModel model = slope("seed = " + std::to_string(seed) +
                                       "\n[domain]\noutline = [[0, 0], [40, 0], [40, 30], [0, 30]]\n"
                                       "block_material = \"rock\"\n" +
                                       sets);
        add_fit({all_traces(model), {{window}, {}}}, tallies);
    }
    return tallies;
}

/// A set of traces whose middles are a Poisson process. The sampler's own sets stop at a density, which then
/// does not vary from map to map as it does in nature.
template <class Length>
void add_poisson_set(std::mt19937& random, double p20, double mean, double sd, Length length,
                     std::vector<Trace>& traces) {
    constexpr double margin = 60;  // longer than half of any trace
    std::poisson_distribution<int> number(p20 * (40 + 2 * margin) * (30 + 2 * margin));
    std::uniform_real_distribution<double> x(-margin, 40 + margin), y(-margin, 30 + margin);
    std::normal_distribution<double> angle(mean, sd);
    for (int k = number(random); k > 0; --k) {
        const Point middle{x(random), y(random)};
        const double a = angle(random), half = length(random) / 2;
        traces.push_back({"t",
                          "t",
                          {{middle.x - half * std::cos(a), middle.y - half * std::sin(a)},
                           {middle.x + half * std::cos(a), middle.y + half * std::sin(a)}}});
    }
}

Tallies truths_of(const std::map<std::string, double>& values) {
    Tallies tallies;
    for (const auto& [name, value] : values) tallies[name].truth = value;
    return tallies;
}

/// Each mean within 5 % of the truth, a direction within 2 degrees, and the truth within 33 to 39 of 40
/// intervals of 90 %.
void expect_true(const std::vector<Tallies>& sets) {
    for (std::size_t k = 0; k < sets.size(); ++k)
        for (const auto& [name, tally] : sets[k]) {
            EXPECT_GE(tally.count, seeds - 2) << k << ' ' << name;
            if (name == "direction")
                EXPECT_NEAR(tally.mean(), tally.truth, 2 * degree) << k;
            else
                EXPECT_NEAR(tally.mean() / tally.truth, 1, 0.05) << k << ' ' << name;
            EXPECT_GE(tally.covering, 33) << k << ' ' << name;
            EXPECT_LE(tally.covering, 39) << k << ' ' << name;
        }
}

/// Mean of |cos| of a normal angle: what of the length counts across the mean direction.
double mean_cosine(double sd) {
    return std::exp(-sd * sd / 2);
}

TEST(FitMap, EstimatesTracesAnywhere) {
    std::vector<Tallies> tallies = {truths_of({{"direction", -60 * degree},
                                               {"scatter", 6 * degree},
                                               {"length", 3},
                                               {"p20", 0.25},
                                               {"p21", 0.75},
                                               {"spacing", 1 / (0.75 * mean_cosine(6 * degree))}}),
                                    truths_of({{"direction", 25 * degree},
                                               {"scatter", 4 * degree},
                                               {"length", 5},
                                               {"length_sd", 2.5},
                                               {"p20", 0.2},
                                               {"p21", 1},
                                               {"spacing", 1 / (mean_cosine(4 * degree))}})};
    const double s2 = std::log(1.25);
    for (int seed = 1; seed <= seeds; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        std::vector<Trace> traces;
        add_poisson_set(random, 0.25, -60 * degree, 6 * degree,
                        std::exponential_distribution<double>(1.0 / 3), traces);
        add_poisson_set(random, 0.2, 25 * degree, 4 * degree,
                        std::lognormal_distribution<double>(std::log(5) - s2 / 2, std::sqrt(s2)), traces);
        add_fit({traces, {{window}, {}}}, tallies);
    }
    expect_true(tallies);
}

// A set within a broader one keeps its scatter, and the broader one its tails.
TEST(FitMap, DividesSetsThatOverlap) {
    std::mt19937 random(5);
    std::vector<Trace> traces;
    const std::exponential_distribution<double> length(0.5);
    add_poisson_set(random, 0.3, 10 * degree, 5 * degree, length, traces);
    add_poisson_set(random, 0.3, 60 * degree, 15 * degree, length, traces);
    const MapFit fit = fit_map({traces, {{window}, {}}}, {});
    ASSERT_EQ(fit.sets.size(), 2u);
    const bool first_is_narrow = fit.sets[0].scatter.value < fit.sets[1].scatter.value;
    const FittedSet& narrow = fit.sets[first_is_narrow ? 0 : 1];
    const FittedSet& broad = fit.sets[first_is_narrow ? 1 : 0];
    EXPECT_NEAR(narrow.scatter.value, 5 * degree, 1 * degree);
    EXPECT_NEAR(broad.scatter.value, 15 * degree, 2 * degree);
    EXPECT_NEAR(broad.direction.value, 60 * degree, 3 * degree);
    EXPECT_EQ(fit_map({traces, {{window}, {}}}, {.sets = 1}).sets.size(), 1u);
}

TEST(FitMap, EstimatesJointsThroughTheMap) {
    const std::string sets = R"(
[[joint_set]]
name = "a"
angle = "-20 deg"
spacing = { law = "lognormal", mean = 0.8, sd = 0.3 }
[[joint_set]]
name = "b"
angle = "70 deg"
spacing = { law = "exponential", mean = 0.6 }
)";
    expect_true(tallies_of(sets, {truths_of({{"spacing", 0.8}, {"spacing_sd", 0.3}, {"p21", 1 / 0.8}}),
                                  truths_of({{"spacing", 0.6}, {"p21", 1 / 0.6}})}));
}

TEST(FitMap, EstimatesTracesOnLines) {
    const std::string sets = R"(
[[joint_set]]
name = "lines"
angle = "15 deg"
spacing = { law = "exponential", mean = 0.7 }
trace_length = { law = "exponential", mean = 4 }
gap = { law = "exponential", mean = 1.5 }
)";
    expect_true(tallies_of(sets, {truths_of({{"spacing", 0.7}, {"length", 4}, {"persistence", 4 / 5.5}})}));
}

}  // namespace
}  // namespace rockslope::blockgen::fit_map_test
