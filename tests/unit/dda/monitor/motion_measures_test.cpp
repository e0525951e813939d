#include "dda/monitor/motion_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockslope::motion_measures_test {
namespace {

using namespace dda;

TimeTable sine(double amplitude) {
    std::vector<double> times, values;
    for (int k = 0; k <= 2000; ++k) {
        times.push_back(1.5 + 0.005 * k);
        values.push_back(amplitude * std::sin(2 * std::numbers::pi * 0.005 * k));
    }
    return {times, values};
}

TEST(MotionMeasures, AreThoseOfTheMotionAsApplied) {
    Stage still, shaken;
    still.name = "settle";
    shaken.name = "shake";
    shaken.base_motions.push_back({"base", sine(3), {{0.0}, {0.0}}});
    shaken.base_motions.push_back({"other", {{0.0, 1.0, 1.5}, {0.0, 1.0, 0.0}}, sine(1)});
    const auto list = motion_measures({still, shaken});
    ASSERT_EQ(list.size(), 2u) << "a direction at rest and a table of uneven times have none";
    EXPECT_EQ(list[0].stage, "shake");
    EXPECT_EQ(list[0].block, "base");
    EXPECT_EQ(list[0].axis, 'x');
    EXPECT_NEAR(list[0].measures.peak_acceleration, 3, 1e-12);
    EXPECT_NEAR(list[0].measures.mean_period, 1, 0.03);
    EXPECT_EQ(list[1].axis, 'y');
    ASSERT_EQ(list[0].spectrum.size(), 7u);
    // An oscillator of the sine's period reaches 1 / (2 z) of its amplitude, less exp(-z w t), after 10 s.
    EXPECT_NEAR(list[0].spectrum[4].absolute_acceleration,
                3 * 10 * (1 - std::exp(-0.05 * 2 * std::numbers::pi * 10)), 1.5);
}

}  // namespace
}  // namespace rockslope::motion_measures_test
