#include "dda/terms/loads.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::loads_test {
namespace {

using namespace scene;
using dda::LoadedFace;

constexpr double water_weight = 9810;

/// The generalised force of a scene's loads on its first free block, without displacement.
Vec6 force_on_first(const Scene& s, double time = 0) {
    const dda::BlockSystem blocks = dda::initial_block_system(s.model);
    const dda::RowMap rows(s.model.motion);
    const std::vector<Vec6> still(s.model.motion.size(), Vec6::Zero());
    return dda::load_forces(s.model, rows, blocks,
                            dda::predict_mid_step(s.model, blocks, still, ThreadPool(1)), {time})[0];
}
/// Largest difference of two forces, over the largest component of the second.
double difference(const Vec6& a, const Vec6& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// The pressure on the top of a unit square decreases from 3 Pa at the right to 1 Pa at the left: 2 + 2 x with
// x from the middle. The force is -2 N. The moment is the integral of -x (2 + 2 x), -1/6. The generalised
// force of eps_y is the force times the arm 1/2, that of gamma is half the moment.
TEST(LineLoad, VariesLinearlyAlongTheFace) {
    Scene s;
    s.box({10, 20}, 1, 1);
    s.model.loads.push_back(dda::LineLoad{{LoadedFace{{2, 0, 1}, 3, 1, {0, 0}, {0, 0}}}, {}});
    const Vec6 expected(0, -2, -1. / 6, 0, -1, -1. / 12);
    EXPECT_LT(difference(force_on_first(s), expected), 1e-14);
}

TEST(LineLoad, ActsOnAPartOfAFaceAndFollowsItsHistory) {
    Scene s;
    s.box({0, 0}, 2, 1);
    // 8 Pa along x on the bottom between x = 1 and x = 1.5: 4 N, 0.25 m right of the centroid and 0.5 m below
    // it.
    s.model.loads.push_back(
        dda::LineLoad{{LoadedFace{{0, 0.5, 0.75}, 0, 0, {8, 0}, {8, 0}}}, dda::TimeTable({0, 1}, {0, 2})});
    const Vec6 expected(4, 0, 2, 1, 0, -1);
    EXPECT_LT(difference(force_on_first(s, 0.5), expected), 1e-14);
    EXPECT_TRUE(force_on_first(s, 0).isZero(0));
    EXPECT_LT(difference(force_on_first(s, 7), 2 * expected), 1e-14);
}

// Archimedes, Eq. (56): by the divergence theorem, the action of water on a submerged block of any shape is
// the weight of the displaced water and the pressure at the centroid.
TEST(HeadWater, LiftsASubmergedBlockByTheDisplacedWeight) {
    Scene s;
    s.block({{{0, 0}, {3, .5}, {2.5, 2}, {2, 1}, {.5, 1.5}}});
    s.model.loads.push_back(dda::HeadWater{{0, 1, 2, 3, 4}, {{0, 4}}, water_weight, {}});
    const dda::AreaMoments m = dda::initial_block_system(s.model).moments[0];
    const double at_centroid = water_weight * (4 - m.centroid.y()) * m.area;
    Vec6 expected = Vec6::Zero();
    expected[1] = water_weight * m.area;
    expected[3] = expected[4] = -at_centroid;
    EXPECT_LT(difference(force_on_first(s), expected), 1e-13);
}

TEST(HeadWater, DoesNotActAboveTheHead) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.model.loads.push_back(dda::HeadWater{{0, 1, 2, 3}, {{0, .25}}, water_weight, {}});
    const Vec6 quarter = force_on_first(s);
    EXPECT_NEAR(quarter[1], water_weight / 4, 1e-10);
    EXPECT_NEAR(quarter[0], 0, 1e-10);
    EXPECT_NEAR(quarter[2], 0, 1e-10);
    s.model.loads[0] = dda::HeadWater{{0, 1, 2, 3}, {{0, -1}}, water_weight, {}};
    EXPECT_TRUE(force_on_first(s).isZero(0));
    s.model.loads[0] = dda::HeadWater{{0, 1, 2, 3}, {{0, 0}}, water_weight, {}};
    EXPECT_TRUE(force_on_first(s).isZero(0));
}

// A head line with bends above a face crosses it twice. The reference is a sum over a million strips.
TEST(HeadWater, FollowsAHeadLineWithBends) {
    Scene s;
    s.block({{{0, 0}, {4, 0}, {4, 1}, {0, 2}}});
    const std::vector<Vec2> head = {{.5, 1.2}, {1.5, 2.5}, {3, .8}};
    s.model.loads.push_back(dda::HeadWater{{2}, head, water_weight, {}});
    const Vec2 from(4, 1);
    const Vec2 along(-4, 1);
    const Vec2 centroid = dda::initial_block_system(s.model).moments[0].centroid;
    const Vec2 normal = -dda::perpendicular(along).normalized();
    Vec6 expected = Vec6::Zero();
    constexpr int strips = 1000000;
    for (int k = 0; k < strips; ++k) {
        const Vec2 at = from + (k + .5) / strips * along;
        const double x = at.x();
        const double level = x < .5    ? 1.2
                             : x < 1.5 ? 1.2 + (x - .5) * 1.3
                             : x < 3   ? 2.5 - (x - 1.5) / 1.5 * 1.7
                                       : .8;
        const double pressure = water_weight * std::max(0.0, level - at.y());
        expected += along.norm() / strips * dda::project(-pressure * normal, at - centroid);
    }
    // The reference errs by the depth of a strip where the head line crosses, 4e-6 m of 1 m.
    EXPECT_LT(difference(force_on_first(s), expected), 1e-9);
}

TEST(JointWater, PushesBothFacesApart) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.box({0, 1}, 1, 1);
    s.model.loads.push_back(dda::JointWater{{2, 4}, 500, {}});
    const Vec6 below = force_on_first(s);
    EXPECT_NEAR(below[1], -500, 1e-12);
    EXPECT_NEAR(below[4], -250, 1e-12);
    s.model.motion[0] = dda::Motion::fixed;
    EXPECT_NEAR(force_on_first(s)[1], 500, 1e-12);
}

TEST(MaxLoadAcceleration, AddsOpposedPressures) {
    Scene s;
    s.box({0, 0}, 1, 1);
    const dda::BlockSystem blocks = dda::initial_block_system(s.model);
    EXPECT_EQ(dda::max_load_acceleration(s.model, blocks), 0);
    s.model.loads.push_back(dda::LineLoad{
        {LoadedFace{{0, 0, 1}, 5e3, 5e3, {0, 0}, {0, 0}}, LoadedFace{{2, 0, 1}, 5e3, 5e3, {0, 0}, {0, 0}}},
        {}});
    EXPECT_NEAR(dda::max_load_acceleration(s.model, blocks), 1e4 / 2500, 1e-12);
    s.model.loads.push_back(dda::BodyLoad{-1, {0, 7}, {}});
    EXPECT_EQ(dda::max_load_acceleration(s.model, blocks), 7);
}

}  // namespace
}  // namespace rockslope::loads_test
