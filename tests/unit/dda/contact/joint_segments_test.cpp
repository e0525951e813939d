#include "dda/contact/joint_segments.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::joint_segments_test {
namespace {

using testing::ElementsAre;

dda::Contact contact(const dda::Vec2& point, const dda::Vec2& normal, double length) {
    dda::Contact c;
    c.corner_block = 1;
    c.edge_block = 0;
    c.point = point;
    c.normal = normal;
    c.tangent = dda::perpendicular(normal);
    c.length = length;
    return c;
}

std::vector<std::vector<dda::ContactIndex>> groups(const std::vector<dda::Contact>& contacts) {
    dda::Model model;
    model.joint_materials.push_back({"rough", joint_tests::granite(), 0, 0});
    model.joint_materials.push_back({"smooth", scene::Scene::mohr_coulomb(30), 0, 0});
    const dda::JointSegments segments(model, contacts);
    std::vector<std::vector<dda::ContactIndex>> found;
    for (std::size_t k = 0; k < segments.count(); ++k)
        found.emplace_back(segments.contacts_of(k).begin(), segments.contacts_of(k).end());
    return found;
}

const dda::Vec2 up(0, 1), down(0, -1);

TEST(JointSegments, BothEndsOfAnOverlapShareASegment) {
    EXPECT_THAT(groups({contact({0, 0}, up, .5), contact({1, 0}, down, .5)}), ElementsAre(ElementsAre(0, 1)));
}

// A block that has come back over a corner of the face below it: the two corners are 0.1 mm apart along the
// joint and 0.02 mm across it, by which the joint has dilated.
TEST(JointSegments, CornersOnADilatedJointShareASegment) {
    EXPECT_THAT(
        groups({contact({0, 2e-5}, up, 5e-5), contact({1e-4, 0}, down, .05), contact({.1, 2e-5}, up, .05)}),
        ElementsAre(ElementsAre(0, 1, 2)));
}

TEST(JointSegments, OtherLinesMaterialsAndBlocksAreSeparate) {
    std::vector<dda::Contact> contacts(5, contact({0, 0}, up, .5));
    contacts[1].point = {1, .2};                         // a step in the face
    contacts[2].normal = {-std::sin(.1), std::cos(.1)};  // another direction
    contacts[3].corner_block = 2;
    contacts[4].joint_material = 1;
    EXPECT_THAT(groups(contacts),
                ElementsAre(ElementsAre(0), ElementsAre(1), ElementsAre(2), ElementsAre(3)));
}

TEST(JointSegments, ABareCornerStandsAlone) {
    EXPECT_THAT(groups({contact({0, 0}, up, 0), contact({1, 0}, up, .5)}),
                ElementsAre(ElementsAre(0), ElementsAre(1)));
}

}  // namespace
}  // namespace rockslope::joint_segments_test
