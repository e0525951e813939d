#include "dda/contact/detect.hpp"

#include <gtest/gtest.h>

#include "dda/contact/candidates.hpp"
#include "support/scene.hpp"

namespace rockslope::detect_test {
namespace {

using namespace scene;
using dda::Contact;
using dda::ContactKind;

std::vector<Contact> detect(const Scene& s, double search_radius = .01) {
    const auto candidates = dda::find_candidates(s.model, s.model.vertices, 2 * search_radius);
    return dda::detect_contacts(s.model, {s.model.vertices, s.model.vertices, search_radius}, candidates,
                                ThreadPool(1));
}

double total_length(const std::vector<Contact>& contacts) {
    double sum = 0;
    for (const Contact& c : contacts) sum += c.length;
    return sum;
}

/// The x coordinates of the contact points, sorted.
std::vector<double> points_along_x(const std::vector<Contact>& contacts) {
    std::vector<double> points;
    for (const Contact& c : contacts) points.push_back(c.point.x());
    std::sort(points.begin(), points.end());
    return points;
}

TEST(Detect, AWholeSharedEdgeIsTwoContactsOfHalfItsLength) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.box({0, 1}, 1, 1);
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 2u);
    for (const Contact& c : contacts) {
        EXPECT_EQ(c.kind, ContactKind::edge_edge);
        EXPECT_DOUBLE_EQ(c.length, .5);
        EXPECT_EQ(c.group, -1) << "one entrance line each: no group";
        EXPECT_NEAR(std::abs(c.normal.y()), 1, 1e-15);
        EXPECT_NEAR(c.gap, 0, 1e-15);
    }
    EXPECT_NE(contacts[0].point.x(), contacts[1].point.x()) << "one at each end";
}

// On free ground a block has the joint of the face that lies there, not of the one that rises from it: at
// both ends of the face, whichever of them begins it.
TEST(Detect, OnFreeGroundABlockHasTheJointOfItsLowerFace) {
    Scene s;
    s.model.joint_materials.push_back({"face", Scene::mohr_coulomb(10), 0, 0});
    s.box({-2, 0}, 5, 1);
    const int block = s.box({0, 1}, 1, 1);
    const auto& topology = s.model.topology;
    for (const dda::CornerIndex corner : topology.corners_of(block)) {
        const bool is_lower =
            s.model.vertices[corner].y() == 1 && s.model.vertices[topology.next[corner]].y() == 1;
        s.model.topology.joint_material[dda::edge_from(corner)] = is_lower ? 1 : 0;
    }
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 2u);
    for (const Contact& c : contacts) EXPECT_EQ(c.joint_material, 1) << c.point.x();
}

TEST(Detect, OffsetSquaresTouchAtBothEndsOfTheOverlap) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.box({.25, 1}, 1, 1);
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_DOUBLE_EQ(total_length(contacts), .75);
    for (const Contact& c : contacts) {
        EXPECT_DOUBLE_EQ(c.length, .375);
        EXPECT_TRUE(c.point == Vec2(.25, 1) || c.point == Vec2(1, 1));
    }
}

TEST(Detect, NormalPointsOutOfTheEdgesBlock) {
    Scene s;
    const int lower = s.box({0, 0}, 1, 1);
    s.box({.25, 1.005}, 1, 1);
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 2u) << "one at each end of the overlap";
    for (const Contact& c : contacts) {
        EXPECT_NEAR(c.normal.y(), c.edge_block == lower ? 1 : -1, 1e-15);
        EXPECT_NEAR(dda::cross(c.tangent, c.normal), -1, 1e-15) << "rock on the tangent's left";
        EXPECT_NEAR(c.gap, .005, 1e-15);
    }
}

TEST(Detect, FacesFartherApartThanTheSearchRadiusHaveNoContact) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.box({0, 1.02}, 1, 1);
    EXPECT_TRUE(detect(s).empty());
    EXPECT_EQ(detect(s, .03).size(), 2u);
}

// Blocks that move together do not meet, however fast they are; blocks that approach each other may.
TEST(Detect, TheSearchRadiusOfAPairGrowsWithItsRelativeMotion) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.box({0, 1.02}, 1, 1);
    const auto found_when_moving = [&](double lower, double upper) {
        auto mid_step = s.model.vertices;
        for (const dda::CornerIndex k : s.model.topology.corners_of(dda::BlockIndex(0)))
            mid_step[k].y() += lower / 2;
        for (const dda::CornerIndex k : s.model.topology.corners_of(dda::BlockIndex(1)))
            mid_step[k].y() += upper / 2;
        const dda::SearchRadius radius(.01, .05, .2);
        const auto candidates = dda::find_candidates(s.model, s.model.vertices, .2);
        return dda::detect_contacts(s.model, {s.model.vertices, mid_step, radius}, candidates, ThreadPool(1))
            .size();
    };
    EXPECT_EQ(found_when_moving(.05, .05), 0u);
    EXPECT_EQ(found_when_moving(.05, 0), 2u);
    EXPECT_EQ(found_when_moving(.05, .047), 0u) << "10 mm and three times 3 mm are less than 20 mm";
    EXPECT_EQ(found_when_moving(.05, .046), 2u) << "10 mm and three times 4 mm are more";
}

TEST(Detect, CornerOnCornerIsAGroupOfTwoEntranceLines) {
    Scene s;
    s.box({0, 0}, 1, 1);
    s.box({-1, -1}, 1, 1);
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_EQ(contacts[0].group, contacts[1].group);
    EXPECT_GE(contacts[0].group, 0);
    for (const Contact& c : contacts) {
        EXPECT_EQ(c.kind, ContactKind::vertex_vertex);
        EXPECT_EQ(c.length, 0);
    }
    EXPECT_NEAR(contacts[0].normal.dot(contacts[1].normal), 0, 1e-15);
}

TEST(Detect, ABareCornerOnAFaceIsOneContact) {
    Scene s;
    s.box({-5, -1}, 10, 1);
    s.block({{{0, 0}, {1, 1}, {-1, 1}}});
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].kind, ContactKind::vertex_edge);
    EXPECT_EQ(contacts[0].length, 0);
}

// The straight corner of the lower block, where a joint ended, is 5 mm from the far face of a thin plate.
TEST(Detect, AStraightCornerDoesNotTouchTheFarFaceOfAThinPlate) {
    Scene s;
    s.block({{{0, -1}, {2, -1}, {2, 0}, {1, 0}, {0, 0}}});
    const int plate = s.box({0, 0}, 2, .005);
    const auto contacts = detect(s, .02);
    ASSERT_EQ(contacts.size(), 3u) << "both ends and the straight corner";
    for (const Contact& c : contacts) {
        EXPECT_NEAR(c.gap, 0, 1e-15) << "corner " << c.corner << " edge " << c.edge;
        EXPECT_NEAR(c.normal.y(), c.edge_block == plate ? -1 : 1, 1e-15)
            << "only the lower face of the plate has contacts";
    }
}

TEST(Detect, AWedgeInANotchRestsOnBothFlanks) {
    Scene s;
    s.block({{{-2, -1}, {2, -1}, {2, 1}, {1, 1}, {0, 0}, {-1, 1}, {-2, 1}}});
    s.block({{{0, 0}, {.5, .5}, {-.5, .5}}});
    const auto contacts = detect(s);
    ASSERT_EQ(contacts.size(), 4u) << "both ends of both flanks";
    double left = 0;
    double right = 0;
    for (const Contact& c : contacts) {
        EXPECT_EQ(c.kind, ContactKind::edge_edge);
        EXPECT_EQ(c.group, -1) << "both lines bear force in a notch";
        EXPECT_NEAR(c.gap, 0, 1e-15);
        (c.normal.x() * (c.edge_block == 0 ? 1 : -1) > 0 ? left : right) += c.length;
    }
    EXPECT_NEAR(left, std::sqrt(.5), 1e-15);
    EXPECT_NEAR(right, std::sqrt(.5), 1e-15);
}

// The order of the blocks decides which of two corners is the contact's corner and which is the end of its
// edge.
TEST(Detect, SwappingTheBlocksKeepsPointsAndLengths) {
    for (const double offset : {-.5, -.25, 0.0, .25, .5}) {
        Scene first;
        first.box({0, 0}, 1, 1);
        first.box({offset, 1}, 1, 1);
        Scene second;
        second.box({offset, 1}, 1, 1);
        second.box({0, 0}, 1, 1);
        // Where two corners meet, the one or the other has the contact; the place is the same.
        const std::vector<double> points = points_along_x(detect(first));
        EXPECT_EQ(points, (std::vector{std::max(offset, 0.0), std::min(offset, 0.0) + 1}));
        EXPECT_EQ(points_along_x(detect(second)), points);
        EXPECT_DOUBLE_EQ(total_length(detect(first)), 1 - std::abs(offset));
        EXPECT_DOUBLE_EQ(total_length(detect(second)), 1 - std::abs(offset));
    }
}

}  // namespace
}  // namespace rockslope::detect_test
