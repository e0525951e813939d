// A slope of 1000 blocks that collapses completely and runs out on a plane for 30 s.

#include "support/collapsing_slope.hpp"
#include "support/slide_monitor.hpp"

using namespace rockslope;

namespace {

using namespace scene;

// A block of 2.5 t that lands at 8 m/s on a spring of 50 GN/m penetrates by v sqrt(m / k) = 1.8 mm. Whether
// this happens is chance. The penetration tolerance of 0.8 mm excludes it by augmentation.
TEST(RunOut, LosesNoneOfThousandBlocksAndBalancesItsEnergy) {
    Scene scene = collapsing_slope(50, 20, 1);
    scene.model.penetration_tolerance = .8e-3;
    SlideMonitor slide(scene, 1, 50);
    slide.print_every(.5);
    slide.run(30);
    EXPECT_GT(slide.mean_displacement(), 40) << "the slope must run out";
    expect_slide_invariants(slide);
}

}  // namespace
