#include "dda/contact/undetected_penetration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dda/contact/candidates.hpp"
#include "dda/contact/detect.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::undetected_penetration_test {
namespace {

using namespace scene;
using dda::Contact;
using dda::UndetectedPenetration;

constexpr double tolerance = 1e-9;
constexpr double clip_depth = 1e-5;

std::vector<UndetectedPenetration> undetected_penetrations(const Scene& s, const std::vector<Vec2>& moved,
                                                           const std::vector<dda::CornerEdge>& candidates,
                                                           const std::vector<Contact>& contacts) {
    return dda::find_undetected_penetrations(
        s.model, {s.model.vertices, moved, candidates, contacts, 1, tolerance, clip_depth}, ThreadPool(1));
}

/// A plate 2 cm thick with its upper face y = 0, edge 2. The corners of a block above it move to given
/// points.
class UndetectedPenetrations : public testing::Test {
  protected:
    UndetectedPenetrations() {
        s.block({{{-1, -.02}, {1, -.02}, {1, 0}, {-1, 0}}});
        s.block({{{0, .1}, {.2, .3}, {-.2, .3}}});
    }
    std::vector<UndetectedPenetration> after(const std::vector<Vec2>& block,
                                             const std::vector<Contact>& contacts = {}) {
        std::vector<Vec2> moved = s.model.vertices;
        std::copy(block.begin(), block.end(), moved.begin() + 4);
        return undetected_penetrations(s, moved, dda::find_candidates(s.model, s.model.vertices, 1),
                                       contacts);
    }
    /// A closed contact of corner 4 with the plate's upper face.
    static Contact contact(double depth) {
        Contact c;
        c.corner = 4;
        c.edge = 2;
        c.corner_block = 1;
        c.edge_block = 0;
        c.gap = -depth;
        c.state = dda::ContactState::locked;
        return c;
    }
    Scene s;
};

TEST_F(UndetectedPenetrations, NoneIfTheCornerStaysOutside) {
    EXPECT_TRUE(after({{0, 1e-12}, {.2, .2}, {-.2, .2}}).empty());
    EXPECT_TRUE(after({{0, -.5 * tolerance}, {.2, .2}, {-.2, .2}}).empty()) << "within the tolerance";
}

TEST_F(UndetectedPenetrations, ACornerWithoutAContactIsFoundWithItsEdgeAndDepth) {
    const auto found = after({{.1, -.005}, {.3, .2}, {-.1, .2}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pair, (dda::CornerEdge{4, 2}));
    EXPECT_NEAR(found[0].depth, .005, 1e-15);
    EXPECT_FALSE(found[0].passed_through);
}

/// A convex block is tested by its lines first. A shallow notch far below makes the same block concave: it is
/// tested in full. Both turn by up to 50 degrees while the corner moves.
TEST(UndetectedPenetrationsOfConvexBlocks, AreThoseOfTheFullTest) {
    RandomSource random(5);
    int found = 0;
    for (int repetition = 0; repetition < 20000; ++repetition) {
        const double angle = random.between(-0.9, 0.9), reach = std::pow(10, random.between(-10, -1));
        const Vec2 from(random.between(-.5, .5), random.between(0, reach));
        const Vec2 to(from.x() + random.between(-reach, reach), random.between(-reach, reach));
        const auto map = [&](const Vec2& point) {
            return Vec2(std::cos(angle) * point.x() - std::sin(angle) * point.y(),
                        std::sin(angle) * point.x() + std::cos(angle) * point.y());
        };
        const auto depths = [&](const std::vector<Vec2>& plate) {
            Scene s;
            s.block({plate});
            s.block({{from, from + Vec2(.2, .2), from + Vec2(-.2, .2)}});
            std::vector<Vec2> moved;
            for (const Vec2& corner : plate) moved.push_back(map(corner));
            for (const Vec2& arm : {Vec2(0, 0), Vec2(.2, .2), Vec2(-.2, .2)}) moved.push_back(map(to + arm));
            std::vector<double> depth;
            for (const UndetectedPenetration& one :
                 undetected_penetrations(s, moved, dda::find_candidates(s.model, s.model.vertices, 1), {}))
                depth.push_back(one.depth);
            return depth;
        };
        const std::vector<double> convex = depths({{-1, -.5}, {1, -.5}, {1, 0}, {-1, 0}});
        const std::vector<double> notched = depths({{-1, -.5}, {0, -.4}, {1, -.5}, {1, 0}, {-1, 0}});
        ASSERT_EQ(convex, notched) << "angle " << angle << ", from " << from.transpose() << " to "
                                   << to.transpose();
        found += convex.empty() ? 0 : 1;
    }
    EXPECT_GT(found, 2000);
    EXPECT_LT(found, 18000);
}

TEST_F(UndetectedPenetrations, AClosedContactAccountsForTwiceItsPenetration) {
    const std::vector<Vec2> dipped = {{0, -.001}, {.2, .2}, {-.2, .2}};
    EXPECT_TRUE(after(dipped, {contact(.001)}).empty());
    EXPECT_TRUE(after(dipped, {contact(.0006)}).empty());
    EXPECT_EQ(after(dipped, {contact(.0004)}).size(), 1U);
    Contact open = contact(.001);
    open.state = dda::ContactState::open;
    EXPECT_EQ(after(dipped, {open}).size(), 1U);
}

TEST_F(UndetectedPenetrations, AContactAccountsForNoOtherCorner) {
    const auto found = after({{0, -.001}, {.2, -.001}, {0, .2}}, {contact(.001)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pair.corner, 5);
}

// A chip on a joint in a shaken slope: its contact was 28 um deep, which turned an edge of 0.26 mm by 6
// degrees. The other corner of that edge fails the entrance-angle test, and no step was short enough for it.
TEST_F(UndetectedPenetrations, AContactAccountsForANeighbourOnAnEdgeThatItsPenetrationTurns) {
    const double depth = 28e-6;
    const auto chip = [&](double edge) {
        return after({{0, -depth}, {edge, -2e-9}, {0, 1e-3}}, {contact(depth)});
    };
    EXPECT_TRUE(chip(.26e-3).empty());
    const double longest = depth / dda::parallel_tolerance;
    EXPECT_TRUE(chip(.99 * longest).empty());
    ASSERT_EQ(chip(1.01 * longest).size(), 1U) << "this corner passes the angle test and gets a contact";
    EXPECT_EQ(chip(1.01 * longest)[0].pair.corner, 5);
}

TEST_F(UndetectedPenetrations, ACornerOutsideAgainPassedThroughTheBlock) {
    const auto found = after({{0, -.5}, {.2, .2}, {-.2, .2}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].passed_through);
    EXPECT_EQ(found[0].pair, (dda::CornerEdge{4, 2})) << "the edge through which it entered";
    EXPECT_NEAR(found[0].depth, .01, 1e-15) << "half-way through the plate";
}

// Two blocks flush with each other. The corner of the upper block was past that of the lower block by a
// fraction of a micron, and less than that behind its upper face. Now it is inside and deeper. It crossed
// only the side face, which is also the nearest, but it fails the entrance-angle test there.
TEST_F(UndetectedPenetrations, ACornerThatSlidAroundAnotherIsFoundWithTheEdgeThatPassesTheAngleTest) {
    Scene flush;
    flush.block({{{0, -1}, {1, -1}, {1, 0}, {0, 0}}});
    flush.block({{{0, 0}, {1 + 2e-7, -2e-8}, {1, 1}, {0, 1}}});
    std::vector<Vec2> moved = flush.model.vertices;
    moved[5] = {1 - 6e-7, -2e-5};
    const auto found =
        undetected_penetrations(flush, moved, dda::find_candidates(flush.model, flush.model.vertices, 1), {});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pair, (dda::CornerEdge{5, 2})) << "the upper face, not the right one";
}

// Two boxes of 1 m in a heap hit face to face and turn as they do. The corner went 16 mm through a face whose
// entrance-angle test it fails. It passes that of the opposite face, which it was 0.9 m behind: a contact
// there would press the boxes together.
TEST_F(UndetectedPenetrations, ACornerIsNotFoundWithAnEdgeOnTheFarSide) {
    Scene boxes;
    boxes.block({{{72.7217, 3.0917}, {73.5110, 3.7057}, {72.8970, 4.4949}, {72.1077, 3.8809}}});
    boxes.block({{{71.9741, 3.9125}, {72.8180, 4.4490}, {72.2815, 5.2929}, {71.4376, 4.7564}}});
    const std::vector<Vec2> moved = {{72.7917, 3.1257}, {73.5999, 3.7144}, {73.0109, 4.5223},
                                     {72.2026, 3.9336}, {72.1466, 3.7497}, {72.8923, 4.4163},
                                     {72.2263, 5.1618}, {71.4806, 4.4952}};
    const auto found =
        undetected_penetrations(boxes, moved, dda::find_candidates(boxes.model, boxes.model.vertices, 1), {});
    ASSERT_FALSE(found.empty());
    const auto of_corner = std::find_if(found.begin(), found.end(),
                                        [](const UndetectedPenetration& f) { return f.pair.corner == 5; });
    ASSERT_NE(of_corner, found.end());
    EXPECT_NEAR(of_corner->depth, .016, .001);
    EXPECT_EQ(of_corner->pair.edge, 2) << "the face that it crossed, not 3, the one opposite to it";
}

TEST_F(UndetectedPenetrations, ACornerThatEntersAndLeavesByOneEdgeIsNotReported) {
    // The plate's middle swings up past the corner and back: the plate turns as it slides.
    s.model.vertices[0] = {-1, -.12};
    s.model.vertices[3] = {-1, -.1};
    s.model.vertices[4] = {.5, -.02};
    s.model.vertices[5] = {.7, .2};
    s.model.vertices[6] = {.3, .2};
    std::vector<Vec2> moved = s.model.vertices;
    moved[0] = {-1, -.02};
    moved[3] = {-1, 0};
    moved[1] = {1, -.12};
    moved[2] = {1, -.1};
    moved[4] = {-.5, -.02};
    moved[5] = {-.3, .2};
    moved[6] = {-.7, .2};
    const auto candidates = dda::find_candidates(s.model, s.model.vertices, 1);
    EXPECT_TRUE(undetected_penetrations(s, moved, candidates, {}).empty());
}

TEST_F(UndetectedPenetrations, AShallowClipOfACornerIsNotReported) {
    // Corner 4 goes past the plate's upper right corner (1, 0), from above it to beside it.
    const auto past = [&](double clip) {
        s.model.vertices[4] = {1 - clip, clip};
        s.model.vertices[5] = {1.5, .5};
        s.model.vertices[6] = {1, .5};
        return after({{1 + clip, -3 * clip}, {1.5, .5}, {1, .5}});
    };
    EXPECT_TRUE(past(clip_depth / 10).empty());
    const auto found = past(.001);
    ASSERT_EQ(found.size(), 2U) << "each corner passed through the other's block";
    EXPECT_TRUE(found[0].passed_through);
    EXPECT_TRUE(found[1].passed_through);
}

TEST_F(UndetectedPenetrations, ACornerThatWasInsideIsReportedIfItGetsDeeper) {
    s.model.vertices[4] = {0, -.001};
    EXPECT_TRUE(after({{.1, -.001}, {.3, .2}, {-.1, .2}}).empty());
    EXPECT_TRUE(after({{0, -.0005}, {.2, .2}, {-.2, .2}}).empty());
    const auto found = after({{0, -.002}, {.2, .2}, {-.2, .2}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pair, (dda::CornerEdge{4, 2})) << "the nearest edge";
}

TEST_F(UndetectedPenetrations, OfTwoCrossedEdgesTheOneThatPassesTheAngleTestIsFound) {
    // The corner crosses the lines of both the upper and the right face; at the end its rock lies to the
    // right.
    s.model.vertices[4] = {1.01, .0005};
    s.model.vertices[5] = {1.5, -.005};
    s.model.vertices[6] = {1.5, .005};
    const auto found = after({{.99, -.005}, {1.5, -.01}, {1.5, 0}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pair, (dda::CornerEdge{4, 1}));
}

TEST_F(UndetectedPenetrations, TheWallOfAHoleIsPenetratedLikeAnyFace) {
    Scene holed;
    holed.block({{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}});
    holed.box({-.5, -.5}, 1, 1);
    std::vector<Vec2> moved = holed.model.vertices;
    for (std::size_t k = 8; k < 12; ++k) moved[k] += Vec2(.6, 0);
    const auto candidates = dda::find_candidates(holed.model, holed.model.vertices, 1);
    const auto found = undetected_penetrations(holed, moved, candidates, {});
    ASSERT_EQ(found.size(), 2U) << "both right corners";
    for (const UndetectedPenetration& penetration : found) {
        EXPECT_NEAR(penetration.depth, .1, 1e-15);
        EXPECT_EQ(penetration.pair.edge, 6) << "the hole's right side";
    }
}

}  // namespace
}  // namespace rockslope::undetected_penetration_test
