#include "dda/joint/locked_slope.hpp"

#include <gtest/gtest.h>

namespace rockslope::locked_slope_test {
namespace {

using dda::slope_paid_by_slip;
using dda::slope_within;

// Under 100 N, a spring of 1 kN/m that slides by 10 mm pays for k s / N = 0.1 of slope.
TEST(LockedSlope, FallsNoFasterThanTheSlipPays) {
    const dda::PayingSlip slip{100, 1000, 0.01, 0};
    for (const int direction : {1, -1}) {
        EXPECT_DOUBLE_EQ(slope_paid_by_slip(direction * 0.25, direction * 0.3, direction, slip),
                         direction * 0.25);
        EXPECT_DOUBLE_EQ(slope_paid_by_slip(direction * 0.1, direction * 0.3, direction, slip),
                         direction * 0.2);
        EXPECT_DOUBLE_EQ(slope_paid_by_slip(direction * 0.5, direction * 0.3, direction, slip),
                         direction * 0.5)
            << "a slope that grows shortens the spring";
    }
}

TEST(LockedSlope, FallsLessWhereTheStrengthRises) {
    EXPECT_DOUBLE_EQ(slope_paid_by_slip(0, 0.3, 1, {100, 1000, 0.01, 0.04}), 0.3 - 0.06);
    EXPECT_DOUBLE_EQ(slope_paid_by_slip(0, 0.3, 1, {100, 1000, 0.01, 0.2}), 0.3)
        << "the strength takes it all";
}

TEST(LockedSlope, IsThatOfThePlaceWhereTheSpringIsUnknown) {
    EXPECT_EQ(slope_paid_by_slip(0.1, 0.3, 1, {100, 0, 0.01, 0}), 0.1);
}

TEST(LockedSlope, IsNoSteeperThanTheStrength) {
    const dda::Strength strength{60, 40, 0};
    EXPECT_DOUBLE_EQ(slope_within(0.7, strength, 100), 0.6);
    EXPECT_DOUBLE_EQ(slope_within(-0.7, strength, 100), -0.4);
    EXPECT_DOUBLE_EQ(slope_within(0.5, strength, 100), 0.5);
}

}  // namespace
}  // namespace rockslope::locked_slope_test
