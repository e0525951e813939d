#include "dda/path/limited_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/pressed_block.hpp"
#include "support/random_patch.hpp"

namespace rockslope::limited_forces_test {
namespace {

using namespace rockslope::dda;
using rockslope::pressed_block::PressedBlock;
using rockslope::random_patch::RandomPatch;

// 0.1 mm into the plane gives 100 N, which bear the load; 0.2 mm along it a shear force of 80 N, of which
// friction bears 50. The blocks' own stiffness gives 0.1 and 0.2 N.
TEST(LimitedForces, OfABlockThatSlides) {
    const PressedBlock block(70);
    std::vector<Vec6> displacement{Vec6::Zero()};
    displacement[0].head<3>() << 2e-4, -1e-4, 3e-4;
    const std::vector<double> length{2.0};
    LimitedForces forces;
    forces.evaluate(block.step(), displacement, length, ThreadPool(1));
    EXPECT_NEAR(forces.elastic()[ContactIndex(0)].normal, 100, 1e-12);
    EXPECT_NEAR(forces.elastic()[ContactIndex(0)].shear, 80, 1e-12);
    const Vec6& unbalanced = forces.unbalanced(RowIndex(0));
    EXPECT_NEAR(unbalanced[0], 0.2 - 70 + 50, 1e-12);
    EXPECT_NEAR(unbalanced[1], -0.1 + 100 - 100, 1e-12);
    EXPECT_NEAR(unbalanced[2], 0.3 / 2, 1e-12) << "a moment over the length";
    EXPECT_NEAR(forces.norm(), std::hypot(unbalanced[0], unbalanced[1], unbalanced[2]), 1e-12);
}

// Blocks share contacts: what a contact gives to one it takes from the other. Two threads find the same
// bytes.
TEST(LimitedForces, AreThoseOfARowOfBlocksWithAnyNumberOfThreads) {
    RandomPatch row(5, 300);
    const std::vector<double> length(row.blocks(), 1.0);
    const std::vector<Vec6> displacement = row.random_displacement();
    LimitedForces one, two;
    one.evaluate(row.step(), displacement, length, ThreadPool(1));
    two.evaluate(row.step(), displacement, length, ThreadPool(2));
    double largest = 0;
    for (const RowIndex r : row.rows()) {
        largest = std::max(largest, one.unbalanced(r).cwiseAbs().maxCoeff());
        EXPECT_EQ(one.unbalanced(r), two.unbalanced(r));
    }
    EXPECT_NEAR(largest, row.unbalanced(displacement), 1e-12 * largest) << "sums in another order";
    EXPECT_EQ(one.norm(), two.norm());
}

}  // namespace
}  // namespace rockslope::limited_forces_test
