#include "dda/joint/linear_angle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rockslope::linear_angle_test {
namespace {

using dda::LinearAngle;

TEST(MeanTangent, IsTheIntegralOfTheTangent) {
    // From 0 to b: -ln cos(b) / b.
    for (const double b : {-1.2, -0.3, 1e-3, 0.5, 1.2})
        EXPECT_NEAR(dda::mean_tangent(0, b), -std::log(std::cos(b)) / b, 1e-12) << b;
    EXPECT_NEAR(dda::mean_tangent(-0.4, 0.4), 0, 1e-16);
}

// tan m + tan''(m) h²/6 with an error of h⁴, here below 1e-20; what is left is rounding of a number near one.
TEST(MeanTangent, LosesNothingWhereTheEndsAreClose) {
    for (const double half : {0.0, 1e-16, 1e-12, 0.9e-8, 1.1e-8, 1e-6, 5e-6}) {
        const double tangent = std::tan(0.7 + half);
        const double expected = tangent * (1 + (1 + tangent * tangent) * half * half / 3);
        EXPECT_NEAR(dda::mean_tangent(0.7, 0.7 + 2 * half), expected, 5e-16) << half;
    }
}

TEST(ClampLeadingPart, CutsAPieceWhereItMeetsALimit) {
    const LinearAngle rising = {4, -1, 3};
    const LinearAngle below = dda::clamp_leading_part(rising, 0, 2);
    EXPECT_DOUBLE_EQ(below.length, 1);
    EXPECT_EQ(below.first, 0);
    EXPECT_EQ(below.last, 0);
    const LinearAngle between = dda::clamp_leading_part({3, 0, 3}, 0, 2);
    EXPECT_DOUBLE_EQ(between.length, 2);
    EXPECT_EQ(between.last, 2);
    const LinearAngle above = dda::clamp_leading_part({1, 2, 3}, 0, 2);
    EXPECT_EQ(above.length, 1);
    EXPECT_EQ(above.first, 2);
    EXPECT_EQ(above.last, 2);
    const LinearAngle falling = dda::clamp_leading_part({4, 3, -1}, 0, 2);
    EXPECT_DOUBLE_EQ(falling.length, 1);
    EXPECT_EQ(falling.first, 2);
}

TEST(EndForceBound, IsTheSmallestOverThePiece) {
    for (const LinearAngle& piece :
         {LinearAngle{2, 0.1, 1.2}, LinearAngle{2, 1.2, 0.1}, LinearAngle{1, 0.6, 0.6}}) {
        for (const double stiffness : {0.0, 0.05, 0.5, 1.0, 5.0}) {
            double smallest = 1e300;
            for (int k = 0; k <= 20000; ++k) {
                const double along = piece.length * k / 20000;
                smallest = std::min(smallest, std::tan(piece.angle_at(along)) + stiffness * (3 - along));
            }
            EXPECT_NEAR(dda::end_force_bound(piece, 1, stiffness, 3), smallest, 1e-7);
        }
    }
}

}  // namespace
}  // namespace rockslope::linear_angle_test
