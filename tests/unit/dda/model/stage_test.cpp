#include "dda/model/stage.hpp"

#include <gtest/gtest.h>

namespace rockslope::stage_test {
namespace {

TEST(NextStepMultiple, IsTheNextMultipleOfTheStep) {
    dda::Stage stage;
    stage.control.step = .005;
    EXPECT_DOUBLE_EQ(dda::next_step_multiple(stage, 0), .005);
    EXPECT_DOUBLE_EQ(dda::next_step_multiple(stage, .001), .005);
    EXPECT_DOUBLE_EQ(dda::next_step_multiple(stage, .005), .01) << "later, not equal";
}

TEST(NextStepMultiple, ToleratesTheRoundingOfASum) {
    dda::Stage stage;
    stage.control.step = .005;
    double time = 0;
    for (int k = 1; k <= 10000; ++k) {
        EXPECT_DOUBLE_EQ(dda::next_step_multiple(stage, time), k * .005);
        time += .005;  // its error grows to 1e-11 s, 2e-9 of a step
    }
}

}  // namespace
}  // namespace rockslope::stage_test
