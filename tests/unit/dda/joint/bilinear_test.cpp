#include "dda/joint/bilinear.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockslope::bilinear_test {
namespace {

constexpr double degree = 0.017453292519943295;
const dda::Bilinear teeth{50 * degree, 30 * degree, 2e6};

TEST(Bilinear, HasTwoSlopesThatMeetAtTheTransition) {
    const auto strength = [&](double force) { return teeth.strength(teeth.fresh(true), force, 0.5).forward; };
    EXPECT_DOUBLE_EQ(strength(4e5), 4e5 * std::tan(50 * degree));
    EXPECT_DOUBLE_EQ(strength(1e6), 1e6 * std::tan(50 * degree));
    EXPECT_DOUBLE_EQ(strength(3e6), 1e6 * std::tan(50 * degree) + 2e6 * std::tan(30 * degree));
    EXPECT_EQ(strength(0), 0);
    EXPECT_EQ(strength(-1e6), 0);
    EXPECT_DOUBLE_EQ(teeth.strength(teeth.fresh(true), 1e6, 0).forward, 1e6 * std::tan(30 * degree))
        << "corner";
}

TEST(Bilinear, SlipAboveTheTransitionShearsTheTeethOff) {
    const auto fresh = teeth.fresh(true);
    EXPECT_FALSE(teeth.advance(fresh, {1e-3, 1e-3, 0.9e6, 0.5}).sheared_off);
    EXPECT_FALSE(teeth.advance(fresh, {0, 1e-3, 3e6, 0.5}).sheared_off) << "no slip";
    const auto off = teeth.advance(fresh, {-1e-3, -1e-3, 1.1e6, 0.5});
    EXPECT_TRUE(off.sheared_off);
    EXPECT_TRUE(teeth.advance(off, {1e-3, 1e-3, 0.1e6, 0.5}).sheared_off);
    EXPECT_DOUBLE_EQ(teeth.strength(off, 4e5, 0.5).forward, 4e5 * std::tan(30 * degree));
    EXPECT_TRUE(teeth.fresh(false).sheared_off);
}

}  // namespace
}  // namespace rockslope::bilinear_test
