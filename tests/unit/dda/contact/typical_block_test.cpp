#include "dda/contact/typical_block.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::typical_block_test {
namespace {

using namespace scene;

// The fixed base, the heaviest block, does not count in the mass; its edges count in the length.
TEST(TypicalBlock, HasTheMedianMassOfTheFreeBlocks) {
    Scene s;
    s.box({-5, -9}, 20, 9, dda::Motion::fixed);
    for (const double side : {4.0, 1.0, 2.0}) s.box({3 * side, 0}, side, side);
    const auto typical = dda::typical_block(s.model);
    ASSERT_TRUE(typical);
    EXPECT_DOUBLE_EQ(typical->mass, 2500 * 4);
    EXPECT_DOUBLE_EQ(typical->face, 4);
}

TEST(TypicalBlock, IsNoneWithoutFreeBlocks) {
    Scene s;
    s.box({0, 0}, 1, 1, dda::Motion::fixed);
    EXPECT_FALSE(dda::typical_block(s.model));
}

}  // namespace
}  // namespace rockslope::typical_block_test
