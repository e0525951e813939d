#include "dda/model/stage.hpp"

#include <gtest/gtest.h>

namespace {

TEST(NextInstant, IsTheNextMultipleOfTheStep) {
    dda::Stage stage;
    stage.control.step = .005;
    EXPECT_DOUBLE_EQ(dda::next_instant(stage, 0), .005);
    EXPECT_DOUBLE_EQ(dda::next_instant(stage, .001), .005);
    EXPECT_DOUBLE_EQ(dda::next_instant(stage, .005), .01) << "later, not equal";
}

TEST(NextInstant, IsNotFooledByTheRoundingOfASum) {
    dda::Stage stage;
    stage.control.step = .005;
    double time = 0;
    for (int k = 1; k <= 10000; ++k) {
        EXPECT_DOUBLE_EQ(dda::next_instant(stage, time), k * .005);
        time += .005;  // off by 1e-11 in the end, a step's 2e-9th part
    }
}

}  // namespace
