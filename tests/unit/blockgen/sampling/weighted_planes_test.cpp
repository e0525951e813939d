#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::weighted_planes_test {
namespace {

using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;

/// A Baecher set of many traces in a section of azimuth 90: x runs east.
SlopeModel set_of_planes(const std::string& planes, int seed = 1) {
    return slope("seed = " + std::to_string(seed) +
                 "\n[domain]\noutline = [[0, 0], [100, 0], [100, 100], [0, 100]]\nblock_material = \"rock\"\n"
                 "[section]\nazimuth = \"90 deg\"\n[[joint_set]]\nname = \"planes\"\nkind = \"baecher\"\n"
                 "trace_length = 1\ncount = 8000\n" +
                 planes);
}

double angle_of(const Trace& trace) {
    const Point &a = trace.points[0], &b = trace.points[1];
    return std::remainder(std::atan2(b.y - a.y, b.x - a.x), std::numbers::pi);
}

// Vertical planes that strike at 60 degrees to the section's normal meet it with a chance of cos 60;
// horizontal ones always do. Both look alike in readings: half and half.
TEST(WeightedPlanes, OccurAsOftenAsTheSectionMeetsThem) {
    const std::string planes = R"(orientations = [["0 deg", "0 deg"], ["90 deg", "30 deg"]])";
    const auto share_of_flat = [&](const std::string& weighting) {
        const std::vector<Trace> traces = all_traces(set_of_planes(planes + weighting));
        double flat = 0;
        for (const Trace& trace : traces) flat += std::abs(angle_of(trace)) < 1e-6;
        return flat / static_cast<double>(traces.size());
    };
    // Three standard errors of a share of 8000.
    EXPECT_NEAR(share_of_flat(""), 0.5, 0.017);
    EXPECT_NEAR(share_of_flat("\nweighting = \"none\""), 0.5, 0.017);
    EXPECT_NEAR(share_of_flat("\nweighting = \"section\""), 1 / 1.5, 0.016);
}

// The mean of a function g of planes that scatter, weighted by their chance h, is E(g h) / E(h).
TEST(WeightedPlanes, ScatterWithTheChanceAsWeight) {
    const std::string planes = "dip = \"60 deg\"\ndip_direction = \"0 deg\"\nfisher_k = 10";
    const auto mean_square_sine = [](const std::vector<Trace>& traces) {
        double sum = 0;
        for (const Trace& trace : traces) sum += std::pow(std::sin(angle_of(trace)), 2);
        return sum / static_cast<double>(traces.size());
    };
    const SlopeModel plain = set_of_planes(planes);
    const Orientation& orientation = plain.joint_sets[0].orientation;
    double weighted = 0, weight = 0;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Pole pole = orientation.draw_pole((i + 0.5) / n, (j + 0.5) / n);
            const double h = section_chance(pole);
            weight += h;
            weighted += h * std::pow(std::sin(trace_angle(pole)), 2);
        }
    const double as_they_are = mean_square_sine(all_traces(plain));
    const double drawn = mean_square_sine(all_traces(set_of_planes(planes + "\nweighting = \"section\"")));
    EXPECT_NEAR(drawn, weighted / weight, 0.012);
    EXPECT_LT(drawn, as_they_are - 0.017);
}

TEST(WeightedPlanes, AreStatedInTheReport) {
    SlopeModel model = set_of_planes(
        "orientations = [[\"0 deg\", \"0 deg\"], [\"60 deg\", \"90 deg\"]]\nweighting = \"section\"");
    model.joint_sets[0].stop.target = 100;
    const CutReport report = cut(model).report;
    EXPECT_THAT(report_text(report), HasSubstr("\"weighting\": \"section\""));
    EXPECT_THAT(report_tables(report), HasSubstr("Terzaghi"));
    EXPECT_THAT(error_of([] { set_of_planes("angle = \"3 deg\"\nweighting = \"section\""); }),
                HasSubstr("weighting"));
}

}  // namespace
}  // namespace rockslope::blockgen::weighted_planes_test
