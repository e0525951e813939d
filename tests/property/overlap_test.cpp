// Tests of the overlap area, which the other property tests use as their measure.

#include "support/overlap.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::overlap_test {
namespace {

using namespace scene;

double area(const Scene& s) {
    const double one = overlap_area(s.model.topology, s.model.vertices, 0, 1);
    EXPECT_NEAR(one, overlap_area(s.model.topology, s.model.vertices, 1, 0), 1e-14) << "must be symmetric";
    return one;
}

TEST(Overlap, OfSquaresIsARectangle) {
    Scene s;
    s.box({0, 0}, 2, 1);
    s.box({1.5, .25}, 3, 3);
    EXPECT_NEAR(area(s), .5 * .75, 1e-15);
}

TEST(Overlap, OfASquareAndOneTurnedBy45DegreesIsAnOctagon) {
    Scene s;
    s.box({-1, -1}, 2, 2);
    s.box({0, -std::sqrt(2.0)}, 2, 2, dda::Motion::free, radians(45));
    EXPECT_NEAR(area(s), 8 * (std::sqrt(2.0) - 1), 1e-14) << "circumscribed about the unit circle";
}

TEST(Overlap, OfCrossedPlatesNeedsNoCornerInside) {
    Scene s;
    s.box({-1, -.005}, 2, .01);
    s.box({-.005, -1}, .01, 2);
    EXPECT_NEAR(area(s), 1e-4, 1e-15);
}

TEST(Overlap, OfNeighboursIsZero) {
    Scene s;
    s.block({{{0, 0}, {1, .1}, {.9, 1.3}, {.1, .8}}});
    s.block({{{1, .1}, {2, 0}, {1.9, 1}, {.9, 1.3}}});
    EXPECT_NEAR(area(s), 0, 1e-15);
}

TEST(Overlap, DoesNotCountHoles) {
    Scene s;
    s.block({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
    s.box({1.5, 1.5}, 1, 1);
    EXPECT_NEAR(area(s), 0, 1e-14) << "a block in the hole";
    Scene reaching;
    reaching.block({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
    reaching.box({1.5, 1.5}, 1.6, 1);
    EXPECT_NEAR(area(reaching), .1, 1e-14) << "0.1 m of the block is in the frame";
}

TEST(Overlap, OfAConcaveBlockCountsBothArms) {
    Scene s;
    s.block({{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
    s.box({-1, 1.5}, 5, .25);
    EXPECT_NEAR(area(s), 2 * .25, 1e-15);
}

TEST(Overlap, FindsAllOverlappingPairs) {
    Scene s;
    for (int k = 0; k < 5; ++k) s.box({.9 * k, 0}, 1, 1);
    s.box({0, 5}, 9, 1);
    const auto found = overlaps(s.model.topology, s.model.vertices);
    ASSERT_EQ(found.size(), 4u);
    for (const Overlap& overlap : found) {
        EXPECT_EQ(overlap.second - overlap.first, 1);
        EXPECT_NEAR(overlap.area, .1, 1e-14);
    }
}

}  // namespace
}  // namespace rockslope::overlap_test
