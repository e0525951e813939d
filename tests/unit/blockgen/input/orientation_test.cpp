#include "blockgen/input/orientation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "blockgen/sampling/random_stream.hpp"
#include "common/base/input_error.hpp"
#include "unit/blockgen/slopes.hpp"
#include "unit/blockgen/statistics.hpp"

namespace rockslope::blockgen::orientation_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

Orientation plane(double dip, double direction, double azimuth, double k = 0) {
    return {{}, {pole_of(dip * degree, direction * degree, azimuth * degree)}, k};
}

TEST(Orientation, ApparentDipAndSpacing) {
    // The worked example: tan(apparent dip) = tan 60 cos 30, and 2 / sqrt(1 - (n.t)^2) with n.t = sin 60
    // sin 30.
    const Orientation o = plane(60, 120, 90);
    EXPECT_NEAR(o.mean_angle(), -56.3099 * degree, 1e-6);
    EXPECT_NEAR(2 * o.spacing_factor(), 2.21880, 1e-5);
    EXPECT_FALSE(o.has_scatter());
    EXPECT_EQ(o.draw(0.1, 0.9), o.mean_angle());
}

TEST(Orientation, PlaneOfAPoleOfEitherSign) {
    for (const double dip : {0.0, 1.0, 45.0, 89.0})
        for (const double direction : {0.0, 33.0, 180.0, 359.0})
            for (const double azimuth : {0.0, 90.0, 250.0, -700.0}) {
                const Pole pole = pole_of(dip * degree, direction * degree, azimuth * degree);
                for (const double sign : {1.0, -1.0}) {
                    const PlaneAngles plane =
                        plane_of({sign * pole.x, sign * pole.up, sign * pole.out}, azimuth * degree);
                    EXPECT_NEAR(plane.dip, dip * degree, 1e-12);
                    if (dip == 0) continue;  // without a dip direction
                    EXPECT_NEAR(std::remainder(plane.dip_direction - direction * degree, 360 * degree), 0,
                                1e-12);
                    EXPECT_GE(plane.dip_direction, 0);
                    EXPECT_LT(plane.dip_direction, 2 * std::numbers::pi);
                }
            }
}

TEST(Orientation, DipsTowardsOrAgainstTheSection) {
    EXPECT_NEAR(plane(30, 90, 90).mean_angle(), -30 * degree, 1e-12);  // down to the right
    EXPECT_NEAR(plane(30, 270, 90).mean_angle(), 30 * degree, 1e-12);
    EXPECT_NEAR(plane(30, 0, 90).mean_angle(), 0, 1e-12);  // strikes along the section
    EXPECT_NEAR(plane(30, 0, 90).spacing_factor(), 1 / std::cos(30 * degree), 1e-12);
    EXPECT_NEAR(std::abs(plane(90, 90, 90).mean_angle()), 90 * degree, 1e-12);
    EXPECT_NEAR(plane(0, 12, 90).spacing_factor(), 1, 1e-12);
    EXPECT_GT(plane(90, 0, 90).spacing_factor(), 1e9);  // parallel to the section
}

TEST(Orientation, FisherScatterAboutTheMean) {
    // About a horizontal plane's pole the angle in the section follows from the pole: its projection on the
    // vertical plane. The angle from the mean follows Fisher's law: P(theta) = (1 - exp(K (cos theta - 1))) /
    // (1 - exp(-2 K)).
    const double k = 30;
    const Orientation o = plane(0, 0, 90, k);
    EXPECT_TRUE(o.has_scatter());
    const RandomStream stream(5, "fisher");
    std::vector<double> cosines;
    double sum = 0;
    constexpr int n = 10000;
    for (int i = 0; i < n; ++i) {
        // With v = 0 the pole stays in the section, so the joint's angle is the angle from the mean pole.
        const double u = stream.draw(0, i, 0);
        cosines.push_back(std::cos(o.draw(u, 0)));
        sum += o.draw(u, stream.draw(0, i, 1));
    }
    EXPECT_LT(ks_distance(cosines,
                          [&](double c) {
                              return (std::exp(k * (c - 1)) - std::exp(-2 * k)) / (1 - std::exp(-2 * k));
                          }),
              ks_limit(n));
    // In the section the angles scatter by about 1 / sqrt(K).
    EXPECT_NEAR(sum / n, 0, 3 / std::sqrt(k * n));
}

// Fisher density K / (4 pi sinh K) exp(K cos theta) about a pole in the section. Integration over the
// latitudes delta gives a density of the longitude proportional to the integral of
// exp(K cos delta cos longitude) cos delta. For axes, the density of the opposite longitude is added.
TEST(Orientation, FisherScatterProjectedIntoTheSection) {
    for (const double k : {3.0, 12.0, 80.0}) {
        constexpr int cells = 2000;
        std::vector<double> cumulative = {0};  // unnormalised distribution of angles from -90 degrees
        for (int i = 0; i < cells; ++i) {
            const double longitude = ((i + 0.5) / cells - 0.5) * std::numbers::pi;
            double density = 0;
            for (int j = 0; j < 400; ++j) {
                const double delta = ((j + 0.5) / 400 - 0.5) * std::numbers::pi;
                const double c = std::cos(delta);
                density += c * (std::exp(k * (c * std::cos(longitude) - 1)) +
                                std::exp(k * (-c * std::cos(longitude) - 1)));
            }
            cumulative.push_back(cumulative.back() + density);
        }
        const Orientation o = plane(35, 90, 90, k);
        const RandomStream stream(11, "section");
        const double mean_angle = o.mean_angle();
        std::vector<double> turns;
        for (int i = 0; i < 10000; ++i)
            turns.push_back(std::remainder(o.draw(stream.draw(0, i, 0), stream.draw(0, i, 1)) - mean_angle,
                                           std::numbers::pi));
        EXPECT_LT(ks_distance(turns,
                              [&](double turn) {
                                  const double at = (turn / std::numbers::pi + 0.5) * cells;
                                  const auto i = static_cast<std::size_t>(std::clamp(at, 0.0, cells - 1.0));
                                  const double f = at - static_cast<double>(i);
                                  return (cumulative[i] + f * (cumulative[i + 1] - cumulative[i])) /
                                         cumulative.back();
                              }),
                  ks_limit(turns.size()))
            << k;
    }
}

TEST(Orientation, BootstrapDrawsEachMeasuredPlaneEquallyOften) {
    const Orientation o{{}, {pole_of(0.3, 1.5, 1.57), pole_of(0.5, 1.5, 1.57), pole_of(0.7, 1.5, 1.57)}, 0};
    EXPECT_TRUE(o.has_scatter());
    const RandomStream stream(5, "bootstrap");
    int count = 0;
    constexpr int n = 10000;
    for (int i = 0; i < n; ++i)
        count += o.draw(stream.draw(0, i, 0), 0.5) == Orientation{{}, {o.poles[1]}, 0}.mean_angle();
    EXPECT_NEAR(count, n / 3.0, 3 * std::sqrt(n * 2.0 / 9));
    EXPECT_NEAR(o.mean_angle(), Orientation({{}, {o.poles[1]}, 0}).mean_angle(), 1e-6);
}

TEST(Orientation, MaxDeviationTangent) {
    const auto degrees = [](const Orientation& o) { return std::atan(o.max_deviation_tangent()) / degree; };
    EXPECT_EQ(plane(60, 120, 90).max_deviation_tangent(), 0);
    EXPECT_EQ((Orientation{constant_value(0.3), {}, 0}).max_deviation_tangent(), 0);
    EXPECT_NEAR(degrees({{Law::uniform, 0, 0, -0.2, 0.4}, {}, 0}), 0.3 / degree, 0.01);
    // Half of 1e-4 on either side of a normal law: 3.8906 standard deviations.
    EXPECT_NEAR(degrees({{Law::normal, 1, 5 * degree}, {}, 0}), 5 * 3.8906, 1e-3);
    EXPECT_NEAR(degrees({{Law::normal, 1, 40 * degree}, {}, 0}), 89, 1e-9);
    // Axes: 170 and -170 degrees are 20 degrees apart.
    EXPECT_NEAR(degrees({{},
                         {pole_of(10 * degree, 90 * degree, 90 * degree),
                          pole_of(10 * degree, 270 * degree, 90 * degree)},
                         0}),
                10, 1e-6);
    EXPECT_NEAR(degrees(plane(60, 90, 90, 2)), 89, 1e-9);
    // No more than one draw in ten thousand lies beyond; a plane oblique to the section scatters more in it.
    for (const double k : {20.0, 50.0, 400.0})
        for (const double direction : {90.0, 120.0, 160.0}) {
            const Orientation o = plane(60, direction, 90, k);
            const double mean_angle = o.mean_angle(), steepest = o.max_deviation_tangent();
            const RandomStream stream(7, "steep");
            int beyond = 0;
            double most = 0;
            for (int i = 0; i < 20000; ++i) {
                const double turn = std::abs(std::remainder(
                    o.draw(stream.draw(0, i, 0), stream.draw(0, i, 1)) - mean_angle, std::numbers::pi));
                beyond += std::tan(turn) > steepest;
                most = std::max(most, turn);
            }
            EXPECT_LE(beyond, 2 + 3) << k << ' ' << direction;
            EXPECT_GT(most, 0.7 * std::atan(steepest)) << k << ' ' << direction;
        }
}

const std::string head =
    "[domain]\noutline = [[0, 0], [20, 0], [20, 10], [0, 10]]\nblock_material = \"rock\"\n"
    "[section]\nazimuth = \"90 deg\"\n[[joint_set]]\nname = \"a\"\nspacing = 2\n";

TEST(Orientation, KeysOfTheModelFile) {
    const JointSet set =
        slope(head + "dip = \"60 deg\"\ndip_direction = \"120 deg\"\nfisher_k = 50\n").joint_sets[0];
    EXPECT_NEAR(set.spacing.mean, 2.21880, 1e-5);
    EXPECT_EQ(set.orientation.fisher_k, 50);
    EXPECT_EQ(slope(head + "orientations = [[\"60 deg\", \"120 deg\"], [\"55 deg\", \"2 rad\"]]\n")
                  .joint_sets[0]
                  .orientation.poles.size(),
              2u);
    for (const char* bad :
         {"dip = \"60 deg\"", "dip = \"100 deg\"\ndip_direction = \"0 deg\"",
          "dip = \"60 deg\"\ndip_direction = \"0 deg\"\nangle = \"1 deg\"",
          "dip = \"90 deg\"\ndip_direction = \"0 deg\"",
          "dip = \"60 deg\"\ndip_direction = \"120 deg\"\nfisher_k = 0", "orientations = []",
          "orientation_file = \"no-such.csv\"", "angle = \"1 deg\"\nfisher_k = 3"})
        EXPECT_THROW(slope(head + bad + "\n"), InputError) << bad;
    std::string without = head;
    without.erase(without.find("[section]"), without.find("[[joint_set]]") - without.find("[section]"));
    EXPECT_THROW(slope(without + "dip = \"60 deg\"\ndip_direction = \"120 deg\"\n"), InputError);
}

TEST(Orientation, MeasuredPlanesFromAFile) {
    const std::string path = testing::TempDir() + "planes.csv";
    std::ofstream(path) << "dip_direction,dip\n120,60\n118,57\n";
    const SlopeModel model = slope(head + "orientation_file = \"" + path + "\"\n");
    ASSERT_EQ(model.joint_sets[0].orientation.poles.size(), 2u);
    EXPECT_NEAR(Orientation({{}, {model.joint_sets[0].orientation.poles[0]}, 0}).mean_angle(),
                -56.3099 * degree, 1e-6);
    EXPECT_EQ(model.files.size(), 1u);
    std::ofstream(path) << "dip,dip_direction\n120,60\n";
    EXPECT_THROW(slope(head + "orientation_file = \"" + path + "\"\n"), InputError);
}

}  // namespace
}  // namespace rockslope::blockgen::orientation_test
