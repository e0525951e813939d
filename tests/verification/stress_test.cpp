// Stresses and strains of blocks at rest.

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace {

using namespace scene;

/// Forces on the corners of a unit square that make a uniform traction: top and bottom, then right and left.
void add_corner_tractions(Scene& s, int block, const Vec2& top, const Vec2& right) {
    const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const Vec2& corner : corners) {
        const Vec2 force = (corner.y() > 0.5 ? 0.5 : -0.5) * top + (corner.x() > 0.5 ? 0.5 : -0.5) * right;
        s.model.loads.push_back(dda::PointLoad{s.material_point(block, corner), force, {}});
    }
}

/// Strains of a square from where its corners went: exact for an affine displacement.
dda::Vec3 strains(const Simulation& sim) {
    const auto& v = sim.state.blocks.vertices;
    const Vec2 along = v[1] - v[0];
    const Vec2 up = v[3] - v[0];
    return {along.x() - 1, up.y() - 1, along.y() + up.x()};
}

// V05, V06. Hooke's law; 0.1 % covers the change of the square's own size (strains of 1e-4) and the settling
// tolerance.
TEST(Elasticity, UniaxialCompression) {
    for (const auto& [plane, axial, lateral] : {std::tuple{dda::Plane::stress, -1e-4, 2.5e-5},
                                                std::tuple{dda::Plane::strain, -9.375e-5, 3.125e-5}}) {
        Scene s;
        s.model.plane = plane;
        s.model.gravity.setZero();
        add_corner_tractions(s, s.box({0, 0}, 1, 1), {0, -1e6}, {0, 0});
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        EXPECT_NEAR(strains(sim)[1], axial, 1e-3 * std::abs(axial));
        EXPECT_NEAR(strains(sim)[0], lateral, 1e-3 * lateral);
        EXPECT_NEAR(sim.stress(0)[1], -1e6, 1e3);
    }
}

TEST(Elasticity, SimpleShear) {
    Scene s;
    s.model.gravity.setZero();
    add_corner_tractions(s, s.box({0, 0}, 1, 1), {1e5, 0}, {0, 1e5});
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    EXPECT_NEAR(strains(sim)[2], 2.5e-5, 2.5e-8);
    EXPECT_NEAR(sim.stress(0)[2], 1e5, 1e2);
}

// V02, V03. W over two springs, and the virial stress of self-weight: sigma_y = -rho g h / 2, sigma_x = 0. In
// ten seconds nothing drifts.
TEST(BlockAtRest, PenetratesByItsWeightAndStays) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    const int block = s.box({0, 0}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    EXPECT_NEAR(sim.reports.back().largest_penetration, 2.4525e-7, 2.4525e-9);
    EXPECT_NEAR(sim.stress(block)[1], -12262.5, 122.6);
    EXPECT_NEAR(sim.stress(block)[0], 0, 122.6);
    ASSERT_EQ(sim.shake(10, 0.005).status, dda::RunStatus::completed);
    EXPECT_LT(sim.moved(block).norm(), 1e-6);
}

// V04. In a smooth column the k-th block from the top carries k - 1/2 blocks.
TEST(Column, StressGrowsWithDepth) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    for (int k = 0; k < 10; ++k) s.box({0, double(k)}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    for (int k = 1; k <= 10; ++k) {
        const double expected = -2500 * g * (k - 0.5);
        EXPECT_NEAR(sim.stress(11 - k)[1], expected, 0.01 * std::abs(expected))
            << "block " << k << " from the top";
    }
}

// V07. n blocks on n joints of stiffness k: 1/E_eff = 1/E + 1/(k h). Every joint has two contacts, so each
// spring is k h / 2.
TEST(Chain, IsAsSoftAsBlocksAndJointsInSeries) {
    Scene s;
    s.model.plane = dda::Plane::stress;
    s.model.gravity.setZero();
    s.model.normal_penalty = s.model.shear_penalty = 0.5e12;
    const int n = 5;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    for (int k = 0; k < n; ++k) s.box({0, double(k)}, 1, 1);
    for (const double x : {0.0, 1.0}) {
        s.model.loads.push_back(dda::PointLoad{s.material_point(n, {x, n}), {0, -0.5e6}, {}});
    }
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    const double shortening = n - sim.state.blocks.points[0].y();
    EXPECT_NEAR(1e6 * n / shortening, 9.901e9, 0.01 * 9.901e9);
}

}  // namespace
