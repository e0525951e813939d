#include "dda/analysis/energy.hpp"

#include <gtest/gtest.h>

namespace rockslope::energy_test {
namespace {

dda::Energy losses(double scale) {
    dda::Energy energy;
    energy.friction_loss = scale;
    energy.damping_loss = 2 * scale;
    energy.contact_damping_loss = 4 * scale;
    energy.numerical_loss = 8 * scale;
    energy.released = 16 * scale;
    energy.boundary_loss = 32 * scale;
    energy.external_work = 64 * scale;
    energy.friction_returned = 128 * scale;
    return energy;
}

TEST(Energy, LossesAndWorkOfAPartAreAdded) {
    dda::Energy all = losses(1);
    all.kinetic = 5;
    all.initial_stores = 7;
    all.add_losses(losses(1000));
    EXPECT_EQ(all.losses(), 63 * 1001);
    EXPECT_EQ(all.external_work, 64 * 1001);
    EXPECT_EQ(all.friction_returned, 128 * 1001);
    EXPECT_EQ(all.stores(), 5);
    EXPECT_EQ(all.initial_stores, 7);
}

TEST(Energy, OfTwoPartsTheLargestGainIsKept) {
    const dda::EnergyGain small{1, 0.5, 2, 3, 4}, large{6, 0.5, 7, 8, 9}, as_large{6, 0.5, 10, 11, 12};
    dda::Energy all, part;
    all.largest_gain = small;
    part.largest_gain = large;
    all.largest_spring_gain = large;
    part.largest_spring_gain = as_large;
    all.add_losses(part);
    EXPECT_EQ(all.largest_gain.corner_block, large.corner_block);
    EXPECT_EQ(all.largest_gain.amount, 6);
    EXPECT_EQ(all.largest_spring_gain.edge_block, large.edge_block) << "the first of equal ones";
}

}  // namespace
}  // namespace rockslope::energy_test
