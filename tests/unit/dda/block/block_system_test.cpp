#include "dda/block/block_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dda/block/mid_step.hpp"
#include "support/scene.hpp"

namespace rockslope::block_system_test {
namespace {

using namespace scene;
using dda::Vec3;

const Vec6 some = (Vec6() << .3, -.2, .4, 1e-3, -2e-3, 3e-3).finished();

Eigen::Matrix2d turn(double angle) {
    Eigen::Matrix2d r;
    r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return r;
}

TEST(RotateTensor, IsTheMatrixProduct) {
    const Vec3 tensor(3, -1, 2);
    for (const double angle : {-10.0, -1e-12, 0.0, 1e-12, .3, 10.0}) {
        Eigen::Matrix2d full;
        full << tensor[0], tensor[2], tensor[2], tensor[1];
        const Eigen::Matrix2d expected = turn(angle) * full * turn(angle).transpose();
        const Vec3 turned = dda::rotate_tensor(tensor, angle, false);
        EXPECT_LT((turned - Vec3(expected(0, 0), expected(1, 1), expected(0, 1))).norm(), 1e-14) << angle;
        const Vec3 engineering = dda::rotate_tensor({tensor[0], tensor[1], 2 * tensor[2]}, angle, true);
        EXPECT_LT((engineering - Vec3(expected(0, 0), expected(1, 1), 2 * expected(0, 1))).norm(), 1e-14)
            << angle;
    }
}

TEST(BlockMap, RotatesExactlyAndStrainsFirst) {
    const dda::BlockMap map({1, 2}, some);
    Eigen::Matrix2d strain;
    strain << some[3], some[5] / 2, some[5] / 2, some[4];
    const Vec2 x(3, 5);
    Eigen::Matrix2d stretch = Eigen::Matrix2d::Identity(), term = stretch;
    for (int k = 1; k < 20; ++k) stretch += term = term * strain / k;
    const Vec2 expected = Vec2(1.3, 1.8) + turn(.4) * stretch * Vec2(2, 3);
    EXPECT_LT((map(x) - expected).norm(), 1e-14);
}

// Below a strain of 1e-4 the exponential is computed by a series: exp(-strain) inverts exp(strain) on both
// sides of that limit.
TEST(BlockMap, IsUndoneByTheOppositeStrain) {
    for (const double size : {1e-9, .99e-4, 1.01e-4, .1}) {
        const Vec6 d = (Vec6() << 0, 0, 0, size, -.5 * size, .7 * size).finished();
        const Eigen::Matrix2d both = dda::BlockMap({0, 0}, d).gradient * dda::BlockMap({0, 0}, -d).gradient;
        EXPECT_LT((both - Eigen::Matrix2d::Identity()).norm(), 1e-15) << size;
    }
}

// T is the tangent of the map: half the displacement has a quarter of the difference.
TEST(DisplacementMatrix, IsTheTangentOfTheMap) {
    const Vec2 centre(1, 2);
    const Vec2 arm(2, -3);
    const auto difference = [&](double scale) {
        const Vec6 d = scale * some;
        return (dda::BlockMap(centre, d)(centre + arm) - centre - arm - dda::displacement_matrix(arm) * d)
            .norm();
    };
    EXPECT_NEAR(difference(1e-2) / difference(5e-3), 4, .05);
    EXPECT_EQ(difference(0), 0);
}

TEST(Project, IsARowOfTheDisplacementMatrix) {
    const Vec2 arm(2, -3);
    for (const Vec2& direction : {Vec2(1, 0), Vec2(0, 1), Vec2(.6, -.8)}) {
        const Vec6 row = dda::displacement_matrix(arm).transpose() * direction;
        EXPECT_LT((dda::project(direction, arm) - row).norm(), 1e-15);
    }
}

TEST(MoveBlocks, MovesPointsStressAndRates) {
    Scene s;
    const int moved = s.box({0, 0}, 2, 1);
    const int still = s.box({5, 0}, 1, 1);
    s.material_point(moved, {2, 1});
    s.model.block_materials[0].initial_stress = {1e6, 0, 0};
    dda::BlockSystem blocks = dda::initial_block_system(s.model);
    blocks.velocity[0][3] = 1;
    const Vec6 quarter = (Vec6() << 10, 0, std::numbers::pi / 2, 0, 0, 0).finished();
    dda::move_blocks(s.model, std::vector<Vec6>{quarter, Vec6::Zero()}, ThreadPool(1), blocks);
    EXPECT_LT((blocks.points[0] - Vec2(10.5, 1.5)).norm(), 1e-14)
        << "arm (1, .5) becomes (-.5, 1) about (11, .5)";
    EXPECT_LT((blocks.centroid(moved) - Vec2(11, .5)).norm(), 1e-14);
    EXPECT_LT((blocks.stress[0] - Vec3(0, 1e6, 0)).norm(), 1e-8);
    EXPECT_LT((blocks.velocity[0].tail<3>() - Vec3(0, 1, 0)).norm(), 1e-14);
    EXPECT_NEAR(blocks.moments[0].xx, 1 * 8. / 12 / 4, 1e-13)
        << "a 2 x 1 rectangle turned upright: 1^3 2 / 12";
    EXPECT_EQ(blocks.centroid(still), Vec2(5.5, .5));
    EXPECT_EQ(blocks.stress[1], Vec3(1e6, 0, 0));
}

TEST(MidStep, HasHalfTheTranslationAndHalfTheRotation) {
    Scene s;
    const int block = s.box({0, 0}, 2, 1);
    s.material_point(block, {2, 1});
    const dda::BlockSystem blocks = dda::initial_block_system(s.model);
    const Vec6 half_turn = (Vec6() << 4, 2, std::numbers::pi, 0, 0, 0).finished();
    const dda::MidStep mid =
        dda::predict_mid_step(s.model, blocks, std::vector<Vec6>{half_turn}, ThreadPool(1));
    EXPECT_LT((mid.centroid[0] - Vec2(3, 1.5)).norm(), 1e-14);
    EXPECT_LT((mid.points[0] - Vec2(2.5, 2.5)).norm(), 1e-14);
    EXPECT_LT((mid.vertices[2] - Vec2(2.5, 2.5)).norm(), 1e-14);
}

}  // namespace
}  // namespace rockslope::block_system_test
