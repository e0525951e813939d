// A slope of 1000 blocks that comes down as a whole and runs out on a plane for 30 s.

#include "support/collapsing_slope.hpp"
#include "support/slide.hpp"

namespace {

using namespace scene;

TEST(RunOut, LosesNoneOfThousandBlocksAndKeepsItsBooks) {
    Slide slide(collapsing_slope(50, 20, 1), 1, 50);
    slide.tell_every(.5);
    slide.run(30);
    EXPECT_GT(slide.mean_way(), 40) << "it has run out";
    expect_nothing_lost(slide);
}

}  // namespace
