#include "dda/model/block_material.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace rockslope::block_material_test {
namespace {

using dda::Mat3;
using dda::Plane;
using dda::Vec3;

dda::BlockMaterial rock(double nu) {
    return {"rock", 2500, 10e9, nu, 0.1, Vec3::Zero()};
}

// The compliance, strains under one stress at a time, is Hooke's law.
TEST(Elasticity, PlaneStressIsHookesLaw) {
    const Mat3 compliance = dda::elasticity(rock(.25), Plane::stress).inverse();
    EXPECT_TRUE(compliance.isApprox((Mat3() << 1, -.25, 0, -.25, 1, 0, 0, 0, 2.5).finished() / 10e9, 1e-14));
}

TEST(Elasticity, PlaneStrainHasNoStrainAcrossTheSection) {
    // eps_x = (1 - nu^2)/E sigma_x - nu (1 + nu)/E sigma_y
    const Mat3 compliance = dda::elasticity(rock(.25), Plane::strain).inverse();
    EXPECT_TRUE(compliance.isApprox(
        (Mat3() << .9375, -.3125, 0, -.3125, .9375, 0, 0, 0, 2.5).finished() / 10e9, 1e-14));
}

TEST(Elasticity, WithoutPoissonsRatioBothPlanesAgree) {
    const Mat3 strain = dda::elasticity(rock(0), Plane::strain);
    EXPECT_EQ(strain, dda::elasticity(rock(0), Plane::stress));
    EXPECT_EQ(strain, (Mat3() << 10e9, 0, 0, 0, 10e9, 0, 0, 0, 5e9).finished());
}

TEST(Elasticity, IsPositiveDefiniteUpToTheIncompressibleLimit) {
    for (const double nu : {0.0, 1e-12, .25, .49, .499999}) {
        for (const Plane plane : {Plane::strain, Plane::stress}) {
            const Mat3 c = dda::elasticity(rock(nu), plane);
            EXPECT_EQ(c, c.transpose());
            EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(c).eigenvalues().minCoeff(), 0) << nu;
        }
    }
}

}  // namespace
}  // namespace rockslope::block_material_test
