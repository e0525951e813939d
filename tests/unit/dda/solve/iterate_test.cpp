#include "dda/solve/iterate.hpp"

#include <gtest/gtest.h>

#include "support/first_step.hpp"

namespace rockslope::iterate_test {
namespace {

using namespace scene;

Vec6 along_x(double displacement) {
    return {displacement, 0, 0, 0, 0, 0};
}

TEST(Iterate, GoesAPartOfTheWayToItsTarget) {
    dda::Iterate iterate(1);
    EXPECT_TRUE(iterate.is_at_target());
    iterate.new_target()[dda::RowIndex(0)] = along_x(4);
    iterate.advance(0.25);
    EXPECT_EQ(iterate.displacement()[dda::RowIndex(0)], along_x(1));
    EXPECT_FALSE(iterate.is_at_target());
    iterate.advance(1);
    EXPECT_EQ(iterate.displacement()[dda::RowIndex(0)], along_x(4));
    EXPECT_TRUE(iterate.is_at_target());
}

TEST(Iterate, BeginsTheNextTargetWhereItIs) {
    dda::Iterate iterate(1);
    iterate.new_target()[dda::RowIndex(0)] = along_x(4);
    iterate.advance(0.5);
    EXPECT_EQ(iterate.new_target()[dda::RowIndex(0)], along_x(2));
}

// What remains may be below the rounding of the displacements: it is not found from their difference.
TEST(Iterate, KeepsWhatRemainsWhenItsTargetIsRefined) {
    dda::Iterate iterate(1);
    iterate.new_target()[dda::RowIndex(0)] = along_x(1);
    iterate.advance(0.5);
    iterate.refined_target()[dda::RowIndex(0)] = along_x(1e20);
    iterate.follow_target();
    FirstStep step;
    step.base.stiffness.assign(1, dda::Mat6::Identity());
    EXPECT_DOUBLE_EQ(iterate.remaining_force(step.problem(), step.pool), 0.5);
}

TEST(Iterate, MayBeMovedByOtherMeans) {
    dda::Iterate iterate(1);
    iterate.new_target()[dda::RowIndex(0)] = along_x(3);
    iterate.movable()[dda::RowIndex(0)] = along_x(1);
    iterate.moved(false);
    EXPECT_FALSE(iterate.is_at_target());
    iterate.follow_target();
    EXPECT_EQ(iterate.displacement()[dda::RowIndex(0)], along_x(1));
    iterate.stop_here();
    EXPECT_TRUE(iterate.is_at_target());
    EXPECT_EQ(iterate.target()[dda::RowIndex(0)], along_x(1));
}

}  // namespace
}  // namespace rockslope::iterate_test
