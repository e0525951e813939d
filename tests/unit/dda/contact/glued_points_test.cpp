#include "dda/contact/glued_points.hpp"

#include <gtest/gtest.h>

#include "support/rock_mesh.hpp"

namespace rockslope::glued_points_test {
namespace {

using namespace scene;

/// Four triangles that meet at the centre of a unit square, numbered round it.
Scene crossed_square(const dda::JointMaterial& joint) {
    Scene s;
    s.model.joint_materials[0] = joint;
    const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int k = 0; k < 4; ++k) s.block({{corners[k], corners[(k + 1) % 4], Vec2(.5, .5)}});
    return s;
}

/// The contacts of a scene after one short step, by pairs of blocks.
std::vector<std::pair<int, int>> pairs_in_contact(const Scene& s) {
    Simulation sim(s);
    EXPECT_EQ(sim.shake(1e-4, 1e-4).status, dda::RunStatus::completed);
    std::vector<std::pair<int, int>> pairs;
    for (const dda::Contact& c : sim.state.contacts.contacts)
        pairs.emplace_back(c.blocks().first.value(), c.blocks().second.value());
    return pairs;
}

bool contains(const std::vector<std::pair<int, int>>& pairs, int first, int second) {
    return std::find(pairs.begin(), pairs.end(), std::pair(first, second)) != pairs.end();
}

TEST(GluedPoints, OppositeTrianglesHaveNoContact) {
    const auto glued = pairs_in_contact(crossed_square(elastic_joint(1e12, 1e12)));
    EXPECT_FALSE(contains(glued, 0, 2));
    EXPECT_FALSE(contains(glued, 1, 3));
    EXPECT_EQ(glued.size(), 8U) << "one at each end of the four joints";
    const auto jointed = pairs_in_contact(crossed_square({"joint", Scene::mohr_coulomb(30, 1e6, 1e6), 0, 0}));
    EXPECT_TRUE(contains(jointed, 0, 2)) << "the bonds around the centre may break";
}

// A row of two triangles that share a corner only: nothing glues them, so they keep their contact.
TEST(GluedPoints, NeighboursThatShareACornerOnlyKeepTheirContact) {
    Scene s;
    s.model.joint_materials[0] = elastic_joint(1e12, 1e12);
    s.block({{Vec2(0, 0), Vec2(1, 0), Vec2(.5, .5)}});
    s.block({{Vec2(.5, .5), Vec2(1, 1), Vec2(0, 1)}});
    EXPECT_TRUE(contains(pairs_in_contact(s), 0, 1));
}

// The corner of a block lies within the face of another; a third one glued to both touches it there only.
TEST(GluedPoints, ACornerOnAFaceBelongsToThePoint) {
    Scene s;
    s.model.joint_materials[0] = elastic_joint(1e12, 1e12);
    s.box({-1, -1}, 2, 1);
    s.block({{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}});
    s.block({{Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)}});
    s.block({{Vec2(0, 0), Vec2(0, 1), Vec2(-1, 1)}});
    const auto pairs = pairs_in_contact(s);
    EXPECT_TRUE(contains(pairs, 0, 1));
    EXPECT_TRUE(contains(pairs, 1, 2));
    EXPECT_TRUE(contains(pairs, 2, 3));
    EXPECT_FALSE(contains(pairs, 0, 2));
    EXPECT_FALSE(contains(pairs, 0, 3));
    EXPECT_FALSE(contains(pairs, 1, 3));
}

// Diagonal neighbours of a mesh of squares struck each other where rows shear differently. With the
// integration that damps nothing steps were then cut again and again.
TEST(GluedPoints, AMeshBetweenDashpotsNeedsNoCuts) {
    const RockMesh mesh(8, 30, RockMesh::Sides::dashpots);
    Simulation sim(mesh.s);
    int cuts = 0;
    sim.on_step = [&](const dda::State&, const dda::StepReport& report) { cuts += report.cuts; };
    ASSERT_EQ(sim.run(mesh.shaken(0, .02, .02, 2e-4)).status, dda::RunStatus::completed);
    EXPECT_EQ(cuts, 0);
}

}  // namespace
}  // namespace rockslope::glued_points_test
