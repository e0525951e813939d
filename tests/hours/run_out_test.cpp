// A slope of 1000 blocks that comes down as a whole and runs out on a plane for 30 s.

#include "support/collapsing_slope.hpp"
#include "support/slide_monitor.hpp"

using namespace rockslope;

namespace {

using namespace scene;

// A block of 2.5 t that lands at 8 m/s goes v sqrt(m / k) = 1.8 mm into a spring of 50 GN/m, and whether one
// does is chance. Contacts that would be deeper than 0.8 mm have their forces augmented instead.
TEST(RunOut, LosesNoneOfThousandBlocksAndBalancesItsEnergy) {
    Scene scene = collapsing_slope(50, 20, 1);
    scene.model.penetration_tolerance = .8e-3;
    SlideMonitor slide(scene, 1, 50);
    slide.print_every(.5);
    slide.run(30);
    EXPECT_GT(slide.mean_displacement(), 40) << "it has run out";
    expect_slide_invariants(slide);
}

}  // namespace
