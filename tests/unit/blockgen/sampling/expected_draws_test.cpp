#include "blockgen/sampling/expected_draws.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/input_error.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::expected_draws_test {
namespace {

const std::string head =
    "seed = 5\n[domain]\noutline = [[0, 0], [60, 0], [60, 15], [30, 40], [0, 40]]\nblock_material = "
    "\"rock\"\n"
    "[[region]]\nname = \"left\"\nblock_material = \"rock\"\npolygon = [[-5, -5], [25, -5], [25, 50], [-5, "
    "50]]\n"
    "[[traces]]\njoint_material = \"bed\"\npoints = [[0, 10], [60, 10]]\n"
    "[[traces]]\njoint_material = \"bed\"\npoints = [[0, 20], [60, 21], [90, 5]]\n"
    "[[joint_set]]\nname = \"set\"\n";

struct Draws {
    double expected = 0, needed = 0;
};

Draws draws_of(const std::string& keys) {
    const SlopeModel model = slope(head + keys);
    const JointSet& set = model.joint_sets[0];
    SetSampler sampler(set, model, {.max_blocks = 10'000'000});
    const RockDomain rock(model, set.region);
    Draws draws{expected_draws(sampler, &rock, model.traces), 0};
    if (set.kind == SetKind::parallel) sample_parallel(sampler);
    if (set.kind == SetKind::cross_jointed) sample_cross_joints(sampler, model.traces);
    if (set.kind == SetKind::baecher) sample_baecher(sampler, rock, {});
    if (set.kind == SetKind::veneziano) sample_veneziano(sampler, rock, {});
    if (set.kind == SetKind::voronoi) sample_voronoi(sampler, rock);
    draws.needed = static_cast<double>(sampler.draw_count());
    return draws;
}

// Each set needs hundreds to thousands of draws, with a scatter far below the required factor of two.
TEST(ExpectedDraws, AreWithinAFactorOfTwo) {
    const std::string lines = "angle = \"20 deg\"\nspacing = 0.1\n",
                      short_traces = "trace_length = { law = \"exponential\", mean = 1 }\n",
                      anywhere = "angle = { law = \"normal\", mean = \"20 deg\", sd = \"15 deg\" }\n",
                      spread = "angle = { law = \"uniform\", min = \"0 deg\", max = \"180 deg\" }\n";
    for (const std::string& keys :
         {lines, lines + "region = \"left\"\n", lines + "origin = [900, -400]\n",
          lines + short_traces + "gap = 0.5\n", lines + short_traces + "gap = 0.5\nregion = \"left\"\n",
          lines + "trace_length = { law = \"lognormal\", mean = 3, sd = 9 }\npersistence = 0.4\n",
          "angle = \"-70 deg\"\nspacing = { law = \"exponential\", mean = 0.2 }\n" + short_traces +
              "gap = 0\n",
          // Most spacings are a small fraction of the mean, and few exceed it.
          std::string("angle = \"-70 deg\"\nspacing = { law = \"lognormal\", mean = 0.3, sd = 6 }\n"),
          anywhere + "spacing = 0.2\n", anywhere + "spacing = 0.2\ngap = 0.5\n" + short_traces,
          spread + "spacing = 0.2\n", lines + "kind = \"cross-jointed\"\nends_on = \"bed\"\n",
          lines + "kind = \"cross-jointed\"\nends_on = \"bed\"\nregion = \"left\"\ntermination = 0.5\n",
          "kind = \"baecher\"\np21 = 0.9\n" + spread + short_traces,
          "kind = \"baecher\"\np21 = 0.9\nregion = \"left\"\n" + spread + short_traces,
          "kind = \"baecher\"\np20 = 0.4\n" + anywhere +
              "trace_length = { law = \"gamma\", mean = 9, sd = 20 }\n",
          "kind = \"baecher\"\np10 = 0.9\n" + spread + short_traces,
          "kind = \"baecher\"\ncount = 700\n" + anywhere + short_traces,
          "kind = \"veneziano\"\np21 = 3\n" + spread,
          "kind = \"veneziano\"\np21 = 3\ngap = 4\n" + spread + short_traces,
          "kind = \"veneziano\"\np10 = 3\npersistence = 0.7\n" + spread + short_traces,
          "kind = \"veneziano\"\ncount = 300\n" + anywhere, std::string("kind = \"voronoi\"\ncount = 800\n"),
          std::string("kind = \"voronoi\"\ncount = 800\nregion = \"left\"\n")}) {
        const Draws draws = draws_of(keys);
        EXPECT_GT(draws.needed, 200) << keys;
        EXPECT_LT(draws.expected, 2 * draws.needed) << keys;
        EXPECT_GT(draws.expected, draws.needed / 2) << keys;
    }
}

std::string refusal_of(const std::string& keys, std::size_t max_blocks) {
    return error_of([&] { all_traces(slope(head + keys), max_blocks); });
}

// Without the check each of these would be sampled for hours, or until memory is exhausted.
TEST(ExpectedDraws, RejectTooLargeSetsBeforeSampling) {
    for (const std::string& keys :
         {std::string("angle = \"3 deg\"\nspacing = 1e-5\n"),
          std::string("angle = \"3 deg\"\nspacing = 1\norigin = [1e12, 1e12]\n"),
          std::string("angle = \"3 deg\"\nspacing = 1\ntrace_length = 1e-9\ngap = 1e-9\n"),
          std::string("kind = \"cross-jointed\"\nangle = \"3 deg\"\nspacing = 1e-5\nends_on = \"bed\"\n"),
          std::string("kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 1\np21 = 1e9\n"),
          std::string("kind = \"baecher\"\nangle = \"3 deg\"\ntrace_length = 1\ncount = 1e9\n"),
          std::string("kind = \"baecher\"\nangle = \"3 deg\"\np21 = 1\n"
                      "trace_length = { law = \"lognormal\", mean = 1, sd = 1e6 }\n"),
          std::string("kind = \"veneziano\"\nangle = \"3 deg\"\np21 = 1e9\n"),
          std::string("kind = \"veneziano\"\nangle = \"3 deg\"\ntrace_length = 1\ngap = 1e12\np21 = 1\n"),
          std::string("kind = \"voronoi\"\ncount = 1e9\n")})
        EXPECT_THAT(
            refusal_of(keys, 1'000'000),
            testing::AllOf(testing::StartsWith("slope.toml:15:"), testing::HasSubstr("needs about "),
                           testing::HasSubstr("at most 1010000 (--max-blocks, 1000000, and 10000 more)")))
            << keys;
}

TEST(ExpectedDraws, AddUpOverAllSets) {
    const std::string first = "angle = \"3 deg\"\nspacing = 0.005\n",
                      second = "[[joint_set]]\nname = \"b\"\n" + first;
    EXPECT_EQ(refusal_of(first, 1), "no error");
    const std::size_t drawn = all_traces(slope(head + first)).size() - slope(head + first).traces.size();
    EXPECT_THAT(refusal_of(first + second, 1),
                testing::AllOf(testing::HasSubstr("joint set 'b' needs about"),
                               testing::HasSubstr("at most " + std::to_string(10'001 - drawn) +
                                                  " (--max-blocks, 1, and 10000 more, less " +
                                                  std::to_string(drawn) + " of the sets before it)")));
    EXPECT_EQ(refusal_of(first + second, 10'000), "no error");
}

}  // namespace
}  // namespace rockslope::blockgen::expected_draws_test
