#include "dda/joint/shear_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cyclic_joints.hpp"
#include "support/cyclic_reference.hpp"

namespace rockslope::shear_test_test {
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
    double largest = 0;
    for (const auto& row : dda::run_shear_test(test)) {
        EXPECT_NEAR(row.normal_stress, 1e6 + 3e9 * row.dilation, 1);
        largest = std::max(largest, row.normal_stress);
    }
    EXPECT_GT(largest, 1.5e6);
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
    double largest = 0;
    for (const auto& row : dda::run_shear_test(test)) {
        const double closed = closing.closure(row.normal_stress) - closing.closure(1e6);
        EXPECT_NEAR(closed + (row.normal_stress - 1e6) / 2e9, row.dilation, 1e-12);
        largest = std::max(largest, row.normal_stress);
    }
    EXPECT_GT(largest, 1.5e6);
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

// --- prescribed normal stress, and the work

TEST(ShearTest, APrescribedStressThatDoesNotChangeIsAConstantOne) {
    ShearTest test = granite_test();
    test.increment = 1e-4;
    const auto constant = dda::run_shear_test(test);
    test.boundary = NormalBoundary::prescribed_stress;
    test.path_stress = {1e6, 1e6, 1e6};
    const auto prescribed = dda::run_shear_test(test);
    ASSERT_EQ(prescribed.size(), constant.size());
    for (std::size_t k = 0; k < constant.size(); ++k) {
        EXPECT_EQ(prescribed[k].shear_stress, constant[k].shear_stress);
        EXPECT_EQ(prescribed[k].dilation, constant[k].dilation);
        EXPECT_EQ(prescribed[k].work, constant[k].work);
    }
}

TEST(ShearTest, APrescribedStressIsLinearBetweenThePoints) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::prescribed_stress;
    test.path = {0, 2e-3, 2e-3, 3e-3};
    test.path_stress = {1e6, 2e6, 0, 0.5e6};
    test.increment = 1e-3;
    const auto rows = dda::run_shear_test(test);
    ASSERT_EQ(rows.size(), 1u + 1 + 20 + 20 + 20);
    for (int k = 1; k <= 20; ++k) {
        EXPECT_NEAR(rows[1 + k].normal_stress, (1 + k / 20.) * 1e6, 1e-9 * 1e6);
        EXPECT_NEAR(rows[1 + k].displacement, k / 20. * 2e-3, 1e-18);
        EXPECT_NEAR(rows[21 + k].normal_stress, (2 - k / 10.) * 1e6, 1e-9 * 1e6);
        EXPECT_EQ(rows[21 + k].displacement, 2e-3);
    }
    EXPECT_EQ(rows[41].shear_stress, 0) << "open";
    EXPECT_GT(rows[61].shear_stress, 0) << "closed again";
}

// From 10 mm on granite slides at 0.15: each metre of slip takes tau - sigma tan(d_t), Eqs. (57) and (60).
TEST(ShearTest, TheWorkOfSlipIsThatOfFriction) {
    ShearTest test = granite_test();
    test.path = {10e-3, 15e-3};
    const auto rows = dda::shear_test_at_path_points(test);
    const auto reference = joint_tests::reference_granite();
    EXPECT_NEAR(rows[1].work - rows[0].work, (reference.tau(0.15) - 1e6 * reference.rate(0.15)) * 5e-3,
                1e-12 * rows[1].work);
}

// The locked joint swings by 0.1 mm under 1.5 MPa and back under 1 MPa. It opens and closes by 14.7 um, and
// its shear stress follows the normal stress, Eq. (77): nothing is gained. A shear stress that did not follow
// would give 7.4 J/m2 away in every loop.
TEST(ShearTest, AnElasticLoopOfDisplacementAndNormalStressTakesNoWork) {
    ShearTest test = granite_test();
    test.boundary = NormalBoundary::prescribed_stress;
    test.path = {5e-3, 4.8e-3, 4.8e-3, 4.9e-3, 4.9e-3, 4.8e-3};
    test.path_stress = {1e6, 1e6, 1.5e6, 1.5e6, 1e6, 1e6};
    const auto rows = dda::shear_test_at_path_points(test);
    for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_EQ(rows[k].slip, rows[0].slip) << "locked";
    const double slope = joint_tests::reference_granite().rate(0.3);
    EXPECT_NEAR(rows[3].dilation - rows[2].dilation, 0.1e-3 * slope, 1e-15);
    const double stiffness = rows[3].shear_stress - rows[2].shear_stress;
    EXPECT_NEAR(rows[3].shear_stress - rows[4].shear_stress, 0.5e6 * slope, 1e-6);
    EXPECT_NEAR(rows[4].shear_stress - rows[5].shear_stress, stiffness, 1e-6);
    EXPECT_NEAR(rows[5].work, rows[1].work, 1e-9) << "of 0.5e6 tan(8.37 deg) 0.1 mm = 7.4 J/m2";
    EXPECT_NEAR(0.5e6 * slope * 0.1e-3, 7.4, 0.05);
}

// Below zero, and from one open instant to another; in between a joint gives back what it has stored.
TEST(ShearTest, CreatedEnergyIsTheFallOfTheWork) {
    const auto created = [](const std::vector<std::pair<double, double>>& work_and_stress) {
        std::vector<dda::ShearTestRow> rows(1);
        for (const auto& [work, stress] : work_and_stress) {
            rows.emplace_back();
            rows.back().work = work;
            rows.back().normal_stress = stress;
        }
        return dda::created_energy(rows);
    };
    EXPECT_EQ(created({{1, 1}, {5, 1}, {2, 1}}), 0);
    EXPECT_EQ(created({{1, 1}, {-3, 1}, {2, 1}}), 3);
    EXPECT_EQ(created({{5, 1}, {4, 0}, {6, 1}, {4, 0}}), 0);
    EXPECT_EQ(created({{5, 1}, {4, 0}, {6, 1}, {2, 0}, {3, 0}}), 2);
}

}  // namespace
}  // namespace rockslope::shear_test_test
