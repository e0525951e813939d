#include "blockgen/input/profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rockslope::blockgen::profile_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fault_of(const std::vector<Point>& profile) {
    const auto fault = find_profile_fault(profile);
    return fault ? std::to_string(fault->point) + ": " + fault->what : "none";
}

TEST(Profile, FaultsAreNamedWithTheirPoint) {
    EXPECT_EQ(fault_of({{0, 1}, {2, 3}, {5, 0}}), "none");
    EXPECT_THAT(fault_of({}), HasSubstr("0 points are no profile"));
    EXPECT_THAT(fault_of({{1, 1}}), HasSubstr("1 point is no profile"));
    EXPECT_THAT(fault_of({{0, 1}, {2, 3}, {2, 3}, {4, 0}}),
                HasSubstr("2: the profile repeats the point at x = 2"));
    EXPECT_THAT(fault_of({{0, 1}, {5, 3}, {4, 3}}),
                HasSubstr("2: the profile runs backwards, from x = 5 to 4"));
    EXPECT_THAT(fault_of({{3, 1}, {3, 4}}), HasSubstr("no width"));
    // The face of a bench is a vertical step; one that turns back is none.
    EXPECT_EQ(fault_of({{0, 9}, {4, 9}, {4, 6}, {4, 5}, {8, 5}, {8, 0}, {9, 0}}), "none");
    EXPECT_THAT(fault_of({{0, 9}, {4, 9}, {4, 5}, {4, 7}, {8, 7}}),
                HasSubstr("3: the profile turns back over itself in the vertical step at x = 4"));
}

TEST(Profile, PartsAreCutAtInterpolatedPoints) {
    const std::vector<Point> profile = {{-2, 0}, {2, 8}, {2, 10}, {6, 2}, {10, 2}};
    EXPECT_THAT(clipped_profile(profile, 0, 4),
                ElementsAre(Point{0, 4}, Point{2, 8}, Point{2, 10}, Point{4, 6}));
    EXPECT_THAT(clipped_profile(profile, 3, 3.5), ElementsAre(Point{3, 8}, Point{3.5, 7}));
    EXPECT_EQ(clipped_profile(profile, -9, 99), profile);
    EXPECT_LT(clipped_profile(profile, 11, 12).size(), 2u);
}

/// The distance of a point from the nearest piece of a line.
double distance_from(const std::vector<Point>& line, const Point& p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < line.size(); ++k) {
        const Point &a = line[k - 1], &b = line[k];
        const double ux = b.x - a.x, uy = b.y - a.y;
        const double t = std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
        least = std::min(least, std::hypot(p.x - a.x - t * ux, p.y - a.y - t * uy));
    }
    return least;
}

TEST(Profile, SimplifiedLinesStayWithinTheTolerance) {
    // A zigzag of 0.1 m along a roof of 40 m by 30 m: below its height only the ridge is left.
    std::vector<Point> zigzag;
    for (int k = 0; k <= 80; ++k)
        zigzag.push_back({double(k), (k <= 40 ? 0.75 * k : 60 - 0.75 * k) + 0.1 * (k % 2)});
    EXPECT_THAT(simplified(zigzag, 0.2), ElementsAre(Point{0, 0}, Point{40, 30}, Point{80, 0}));
    EXPECT_EQ(simplified(zigzag, 0), zigzag);
    EXPECT_EQ(simplified({{{0, 0}, {1, 1}, {3, 3}}}, 0), (std::vector<Point>{{0, 0}, {3, 3}}));

    std::mt19937 random(3);
    std::uniform_real_distribution<double> step(-1, 1);
    std::vector<Point> walk = {{0, 0}};
    for (int k = 1; k < 3000; ++k) walk.push_back({double(k), walk.back().y + step(random)});
    std::size_t before = walk.size() + 1;
    for (const double tolerance : {0.1, 0.5, 2.0, 10.0}) {
        const std::vector<Point> line = simplified(walk, tolerance);
        EXPECT_LT(line.size(), before) << tolerance;
        before = line.size();
        EXPECT_EQ(line.front(), walk.front());
        EXPECT_EQ(line.back(), walk.back());
        // The tolerance holds for the piece over each point, so for the nearest piece, too; the second term
        // is the rounding of the distances, which are of numbers up to 3000.
        for (const Point& p : walk) EXPECT_LE(distance_from(line, p), tolerance + 1e-12) << tolerance;
    }
}

}  // namespace
}  // namespace rockslope::blockgen::profile_test
