#include "dda/joint/shear_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cyclic_joints.hpp"

using namespace rockslope;

namespace {

using dda::NormalBoundary;
using dda::ShearTest;

ShearTest granite_test() {
    ShearTest test;
    test.material.law = joint_tests::granite();
    test.length = 0.1;
    test.normal_stress = 1e6;
    test.path = {5e-3, -2e-3, 1e-3};
    test.increment = 1e-5;
    return test;
}

TEST(ShearTest, RowsBeginAtTheStartAndEndAtEachTurn) {
    ShearTest test = granite_test();
    test.increment = 1.1e-3;
    const auto rows = dda::run_shear_test(test);
    ASSERT_EQ(rows.size(), 1u + 5 + 7 + 3);
    EXPECT_EQ(rows[0].displacement, 0);
    EXPECT_EQ(rows[0].shear_stress, 0);
    EXPECT_EQ(rows[5].displacement, 5e-3);
    EXPECT_EQ(rows[12].displacement, -2e-3);
    EXPECT_EQ(rows.back().displacement, 1e-3);
    for (const auto& row : rows) EXPECT_EQ(row.normal_stress, 1e6);
    const auto turns = dda::shear_test_at_path_points(test);
    ASSERT_EQ(turns.size(), 3u);
    EXPECT_EQ(turns[1].shear_stress, rows[12].shear_stress);
}

TEST(ShearTest, ThePointsOfAPathMayRepeat) {
    ShearTest test = granite_test();
    test.path = {0, 1e-3, 1e-3, 2e-3};
    EXPECT_EQ(dda::shear_test_at_path_points(test).size(), 4u);
}

TEST(ShearTest, SpringIsTheMaterialsOrTheLaws) {
    ShearTest test = granite_test();
    EXPECT_NEAR(dda::shear_stiffness(test), 1.92024e6 / 1.25e-3, 1e4);
    test.material.shear_stiffness = 3e9;
    EXPECT_EQ(dda::shear_stiffness(test), 3e9);
    test.material = {};
    EXPECT_EQ(dda::shear_stiffness(test), 0) << "Mohr-Coulomb has none";
}

TEST(ShearTest, NormalStressGrowsWithDilationUnderConstantStiffness) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::constant_stiffness;
    test.boundary_stiffness = 2e9;
    test.material.normal_stiffness = 3e9;
    const double together = 1 / (1 / 2e9 + 1 / 3e9);
    bool grew = false;
    for (const auto& row : dda::run_shear_test(test)) {
        EXPECT_NEAR(row.normal_stress, 1e6 + together * row.dilation, 1);
        grew = grew || row.normal_stress > 1.5e6;
    }
    EXPECT_TRUE(grew);
}

TEST(ShearTest, ConstantVolumeCompressesTheJointItself) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::constant_volume;
    test.material.normal_stiffness = 3e9;
    for (const auto& row : dda::run_shear_test(test))
        EXPECT_NEAR(row.normal_stress, 1e6 + 3e9 * row.dilation, 1);
}

// The joint is closed further by just its dilation, along the hyperbola.
TEST(ShearTest, ConstantVolumeClosesAlongTheHyperbola) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::constant_volume;
    test.material.normal_stiffness = 3e9;
    test.material.largest_closure = 2e-3;
    const dda::NormalClosure closing{3e9, 2e-3};
    double largest = 0;
    for (const auto& row : dda::run_shear_test(test)) {
        EXPECT_NEAR(closing.closure(row.normal_stress) - closing.closure(1e6), row.dilation, 1e-12);
        largest = std::max(largest, row.normal_stress);
    }
    EXPECT_GT(largest, 2e6);
}

TEST(ShearTest, ConstantStiffnessAndClosureShareTheDilation) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::constant_stiffness;
    test.boundary_stiffness = 2e9;
    test.material.normal_stiffness = 3e9;
    test.material.largest_closure = 5e-4;
    const dda::NormalClosure closing{3e9, 5e-4};
    for (const auto& row : dda::run_shear_test(test)) {
        const double closed = closing.closure(row.normal_stress) - closing.closure(1e6);
        EXPECT_NEAR(closed + (row.normal_stress - 1e6) / 2e9, row.dilation, 1e-12);
    }
}

// Without dilation all three boundaries are the same.
TEST(ShearTest, BoundariesDifferByDilationOnly) {
    auto law = joint_tests::granite();
    law.damage = 0;
    ShearTest test = granite_test();
    test.material.law = law;
    const auto constant = dda::run_shear_test(test).back();
    test.boundary = NormalBoundary::constant_stiffness;
    test.boundary_stiffness = 1e12;
    EXPECT_NEAR(dda::run_shear_test(test).back().shear_stress, constant.shear_stress, 1e-6);
}

// The normal stress of a row acts over the increment before it: the error falls with the increment.
TEST(ShearTest, ConstantStiffnessConvergesWithTheIncrement) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::constant_stiffness;
    test.boundary_stiffness = 2e9;
    test.path = {5e-3};
    const auto stress = [&](double increment) {
        test.increment = increment;
        return dda::run_shear_test(test).back().normal_stress;
    };
    const double coarse = stress(2e-4), middle = stress(1e-4), fine = stress(5e-5);
    EXPECT_NEAR((coarse - middle) / (middle - fine), 2, 0.3) << "first order";
    EXPECT_NEAR(middle, fine, 0.01 * fine);
}

// Contraction unloads the joint, at last altogether: it opens and bears nothing.
TEST(ShearTest, AContractingJointUnloadsUnderAStiffBoundary) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::constant_stiffness;
    test.normal_stress = 2e5;  // lost after 50 um
    test.boundary_stiffness = 4e9;
    test.path = {15e-3, -15e-3, 15e-3, -15e-3, 0};
    test.increment = 2e-5;
    bool opened = false;
    for (const auto& row : dda::run_shear_test(test)) {
        EXPECT_GE(row.normal_stress, 0);
        if (row.normal_stress > 0) continue;
        opened = true;
        EXPECT_EQ(row.shear_stress, 0);
    }
    EXPECT_TRUE(opened);
}

}  // namespace
