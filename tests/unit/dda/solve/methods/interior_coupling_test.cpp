#include <gtest/gtest.h>

#include "support/wall_from_inside.hpp"

namespace rockslope::interior_coupling_test {
namespace {

using namespace scene;

class InteriorCouplingOfWalls : public testing::TestWithParam<unsigned> {};

// Friction of 34 degrees makes the system unsymmetric. With the symmetric part alone no wall is solved in the
// 40 iterations that the method has; with the coupled system each took 22 to 29.
TEST_P(InteriorCouplingOfWalls, SolvesWhatTheSymmetricPartAloneDoesNot) {
    WallFromInside rough(GetParam(), 0.6);
    EXPECT_TRUE(rough.interior.solve(rough.d, {}).converged);
}

// Without friction nothing is coupled: prediction and correction take one substitution each. With friction
// each may take 17, one for the start and one for each direction.
TEST_P(InteriorCouplingOfWalls, CostsSubstitutionsWithFrictionOnly) {
    WallFromInside smooth(GetParam(), 0), rough(GetParam(), 0.6);
    const dda::InteriorPointResult without = smooth.interior.solve(smooth.d, {});
    const dda::InteriorPointResult with = rough.interior.solve(rough.d, {});
    EXPECT_EQ(without.substitutions, 2 * without.iterations);
    EXPECT_GT(with.substitutions, 4 * with.iterations);
    EXPECT_LE(with.substitutions, 34 * with.iterations);
}

INSTANTIATE_TEST_SUITE_P(Seeds, InteriorCouplingOfWalls, testing::Range(1U, 9U));

}  // namespace
}  // namespace rockslope::interior_coupling_test
