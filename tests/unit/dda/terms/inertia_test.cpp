#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>

#include "dda/terms/system.hpp"
#include "support/scene.hpp"

namespace rockslope::inertia_test {
namespace {

using namespace scene;
using dda::Mat6;

/// Integral of rho T^T T over rectangles by the Gauss rule with two points in each direction, exact for
/// cubics.
Mat6 quadrature(const std::vector<std::array<double, 4>>& rectangles, const Vec2& centroid, double density) {
    Mat6 sum = Mat6::Zero();
    for (const auto& [left, bottom, right, top] : rectangles) {
        for (const double sx : {-1.0, 1.0}) {
            for (const double sy : {-1.0, 1.0}) {
                const Vec2 point((left + right) / 2 + sx * (right - left) / std::sqrt(12),
                                 (bottom + top) / 2 + sy * (top - bottom) / std::sqrt(12));
                const auto t = dda::displacement_matrix(point - centroid);
                sum += density * (right - left) * (top - bottom) / 4 * t.transpose() * t;
            }
        }
    }
    return sum;
}

TEST(MassMatrix, IsTheIntegralOfEquation11) {
    Scene s;
    s.block({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}});
    const dda::BlockSystem blocks = dda::initial_block_system(s.model);
    const Mat6 m = dda::mass_matrix(blocks.mass[0], blocks.moments[0]);
    const Mat6 expected = quadrature({{0, 0, 3, 1}, {0, 1, 1, 4}}, blocks.centroid(0), 2500);
    EXPECT_GT(std::abs(expected(2, 3)), 1) << "the block must be asymmetric, so that no entry vanishes";
    EXPECT_LT((m - expected).norm(), 1e-12 * expected.norm());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat6>(m).eigenvalues().minCoeff(), 0);
}

// The displacement computed from accelerations, Eq. (14), gives the same accelerations, Eqs. (15) and (16).
TEST(Newmark, InvertsItsOwnDisplacement) {
    const Vec6 v0 = Vec6::LinSpaced(1, 6);
    const Vec6 a0 = Vec6::LinSpaced(-3, 2);
    const Vec6 a1 = Vec6::LinSpaced(7, -5);
    for (const auto& [beta, gamma] : {std::pair{.5, 1.0}, std::pair{.25, .5}, std::pair{.3, .6}}) {
        const dda::Newmark newmark{beta, gamma, .01};
        const Vec6 d = .01 * v0 + 1e-4 * ((.5 - beta) * a0 + beta * a1);
        EXPECT_LT((newmark.acceleration(d, v0, a0) - a1).norm(), 1e-9);
        EXPECT_LT((newmark.velocity(v0, a0, a1) - v0 - .01 * ((1 - gamma) * a0 + gamma * a1)).norm(), 1e-14);
    }
    const dda::Newmark shi{.5, 1, .01};
    const Vec6 d = Vec6::Ones();
    EXPECT_LT((shi.velocity(v0, a0, shi.acceleration(d, v0, a0)) - (2 * d / .01 - v0)).norm(), 1e-11);
}

// The solution for one free block must satisfy M a1 + alpha M v1 = 0.
TEST(Inertia, BalancesDampingAtTheEndOfTheStep) {
    Scene s;
    s.box({0, 0}, 2, 1);
    dda::BlockSystem blocks = dda::initial_block_system(s.model);
    blocks.velocity[0] = Vec6::LinSpaced(1, 6);
    blocks.acceleration[0] = Vec6::LinSpaced(-3, 2);
    const dda::RowMap rows(s.model.motion);
    for (const auto& [beta, gamma] : {std::pair{.5, 1.0}, std::pair{.25, .5}}) {
        const dda::Newmark newmark{beta, gamma, .01};
        const double alpha = 3;
        dda::BaseSystem base{{Mat6::Zero()}, {Vec6::Zero()}};
        dda::add_inertia(rows, blocks, newmark, alpha, base);
        const Vec6 d = base.stiffness[0].ldlt().solve(base.load[0]);
        const Vec6 a1 = newmark.acceleration(d, blocks.velocity[0], blocks.acceleration[0]);
        const Vec6 v1 = newmark.velocity(blocks.velocity[0], blocks.acceleration[0], a1);
        EXPECT_LT((a1 + alpha * v1).norm(), 1e-9 * (alpha * v1).norm());
    }
}

TEST(RowMap, NumbersTheFreeBlocks) {
    using dda::Motion;
    const dda::RowMap rows({Motion::fixed, Motion::free, Motion::prescribed, Motion::free});
    EXPECT_EQ(rows.row_of, (std::vector<dda::RowIndex>{-1, 0, -1, 1}));
    EXPECT_EQ(rows.block_of, (std::vector<dda::BlockIndex>{1, 3}));
}

}  // namespace
}  // namespace rockslope::inertia_test
