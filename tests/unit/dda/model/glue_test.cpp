#include "dda/model/glue.hpp"

#include <gtest/gtest.h>

#include "support/bar.hpp"

namespace rockslope::glue_test {
namespace {

using namespace scene;

/// Two squares in a row, the second cut by a diagonal if asked. All faces between them are joints.
Scene row_of_two(bool cut_second, const dda::JointMaterial& joint) {
    Scene s;
    s.model.joint_materials = {};
    s.model.joint_materials.push_back(joint);
    s.box({0, 0}, 1, 1);
    s.model.topology.joint_material[1] = 0;
    if (cut_second) {
        s.block({{Vec2(1, 0), Vec2(2, 1), Vec2(1, 1)}});
        s.block({{Vec2(1, 0), Vec2(2, 0), Vec2(2, 1)}});
        for (const int edge : {4, 6, 9}) s.model.topology.joint_material[edge] = 0;
    } else {
        s.box({1, 0}, 1, 1);
        s.model.topology.joint_material[7] = 0;
    }
    return s;
}

TEST(GluedPolygons, AreToldFromTwoOnWhereTheJointCannotBreak) {
    const auto told = dda::glued_polygons(row_of_two(false, elastic_joint(1e12, 1e12)).model);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->blocks, 2);
    EXPECT_EQ(told->first, 0);
    EXPECT_EQ(told->joint_material, 0);
    EXPECT_FALSE(dda::glued_polygons(row_of_two(true, elastic_joint(1e12, 1e12)).model)) << "one square only";
    const dda::JointMaterial strong{"strong", Scene::mohr_coulomb(30, 1e9, 1e9), 0, 0};
    EXPECT_FALSE(dda::glued_polygons(row_of_two(false, strong).model)) << "a bond of finite strength";
}

TEST(GluedPolygons, FixedBlocksAndStraightCornersDoNotCount) {
    Scene s = row_of_two(false, elastic_joint(1e12, 1e12));
    s.model.motion[1] = dda::Motion::fixed;
    EXPECT_FALSE(dda::glued_polygons(s.model));

    Scene triangles;
    triangles.model.joint_materials[0] = elastic_joint(1e12, 1e12);
    triangles.block({{Vec2(0, 0), Vec2(.5, 0), Vec2(1, 0), Vec2(0, 1)}});
    triangles.block({{Vec2(1, 0), Vec2(1, 1), Vec2(.5, .5), Vec2(0, 1)}});
    for (int edge = 0; edge < 8; ++edge) triangles.model.topology.joint_material[edge] = 0;
    EXPECT_FALSE(dda::glued_polygons(triangles.model));
}

}  // namespace
}  // namespace rockslope::glue_test
