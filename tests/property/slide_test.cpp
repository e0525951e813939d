// A slope that collapses completely and runs out on a plane.

#include <gtest/gtest.h>

#include "support/collapsing_slope.hpp"
#include "support/slide_monitor.hpp"

namespace rockslope::slide_test {
namespace {

using namespace scene;

// 120 blocks slide down, break up and run out for 10 s.
TEST(LongSlide, LosesNoBlockAndBalancesItsEnergy) {
    SlideMonitor slide(collapsing_slope(20, 6, 1), 1, 20);
    slide.run(10);
    EXPECT_GT(slide.mean_displacement(), 20) << "the slope must run out";
    expect_slide_invariants(slide);
}

}  // namespace
}  // namespace rockslope::slide_test
