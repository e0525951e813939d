#include "dda/input/read_face_loads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/dda/input/model_text.hpp"

namespace rockslope::dda::read_face_loads_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string model_text = io_test::two_blocks_with_friction("30 deg") + R"([joint_material.fault]
law = "mohr-coulomb"
friction_angle = "20 deg"
[[line_load]]
along = [[1, 2], [3, 2], [3, 1]]
pressure = "3 kPa"
pressure_end = 0
[[line_load]]
along = [[1, 1], [3, 1]]
at = [2, 1.5]
traction = [0, "2 kPa"]
traction_end = [0, "4 kPa"]
history = { times = [0, 1], values = [0, 1] }
[[joint_water]]
pressure = "5 kPa"
joint_set = "set"
[[head_water]]
head = [[0, 2], [4, 1.5]]
region = [[0.5, 0.5], [3.5, 0.5], [3.5, 1.8], [0.5, 1.8]]
[[stage]]
kind = "dynamic"
duration = 1
)";

class ReadFaceLoads : public io_test::ModelTextTest {
  protected:
    ReadFaceLoads() : ModelTextTest(model_text) {}
};

// The free block has its corners 6 to 9 at (1, 1), (3, 1), (3, 2), (1, 2); its bottom is the joint.
TEST_F(ReadFaceLoads, ReadsEveryKey) {
    const Model model = read(model_text).model;
    ASSERT_EQ(model.loads.size(), 4u);
    const auto& pressure = std::get<LineLoad>(model.loads[0]);
    ASSERT_EQ(pressure.faces.size(), 2u);
    EXPECT_EQ(pressure.faces[0].face.edge, 8) << "the top runs against the line";
    EXPECT_DOUBLE_EQ(pressure.faces[0].pressure_from, 1000);
    EXPECT_DOUBLE_EQ(pressure.faces[0].pressure_to, 3000);
    EXPECT_EQ(pressure.faces[1].face.edge, 7);
    EXPECT_DOUBLE_EQ(pressure.faces[1].pressure_from, 0);
    EXPECT_DOUBLE_EQ(pressure.faces[1].pressure_to, 1000);
    EXPECT_TRUE(pressure.history.empty());
    const auto& traction = std::get<LineLoad>(model.loads[1]);
    ASSERT_EQ(traction.faces.size(), 1u) << "the base cannot move";
    EXPECT_EQ(traction.faces[0].face.edge, 6);
    EXPECT_EQ(traction.faces[0].traction_from, Vec2(0, 2000));
    EXPECT_EQ(traction.faces[0].traction_to, Vec2(0, 4000));
    EXPECT_EQ(traction.history.at(0.5), 0.5);
    const auto& joint = std::get<JointWater>(model.loads[2]);
    EXPECT_THAT(joint.edges, ElementsAre(6));
    EXPECT_EQ(joint.pressure, 5000);
    const auto& head = std::get<HeadWater>(model.loads[3]);
    EXPECT_THAT(head.edges, ElementsAre(6, 7, 9)) << "the top's middle is outside the region";
    EXPECT_THAT(head.head, ElementsAre(Vec2(0, 2), Vec2(4, 1.5)));
    EXPECT_EQ(head.unit_weight, 9810);
}

TEST_F(ReadFaceLoads, TheEffectiveModelReadsBackToTheSame) {
    const RunInput first = read(model_text);
    const Model again = read(first.effective).model;
    ASSERT_EQ(again.loads.size(), 4u);
    const auto& line = std::get<LineLoad>(again.loads[0]);
    EXPECT_DOUBLE_EQ(line.faces.at(0).pressure_from, 1000);
    EXPECT_EQ(std::get<LineLoad>(again.loads[1]).faces.at(0).traction_to, Vec2(0, 4000));
    EXPECT_EQ(std::get<LineLoad>(again.loads[1]).history.values(), std::vector<double>({0, 1}));
    EXPECT_THAT(std::get<JointWater>(again.loads[2]).edges, ElementsAre(6));
    EXPECT_THAT(std::get<HeadWater>(again.loads[3]).edges, ElementsAre(6, 7, 9));
    EXPECT_EQ(std::get<HeadWater>(again.loads[3]).head, std::get<HeadWater>(first.model.loads[3]).head);
    EXPECT_THAT(first.effective, HasSubstr("free_faces = true  # default"));
}

TEST_F(ReadFaceLoads, WaterIsRestrictedToJointsAndMaterials) {
    const Model model = read(changed("head = [[0, 2]",
                                     "free_faces = false\njoint_material = \"bedding\"\n"
                                     "head = [[0, 2]"))
                            .model;
    EXPECT_THAT(std::get<HeadWater>(model.loads[3]).edges, ElementsAre(6));
    EXPECT_THAT(error_with("joint_set = \"set\"", "joint_material = \"fault\""),
                HasSubstr("[joint_water[0]] wets no face of a block that can move"));
}

// Coordinates of lines, regions and heads are relative to the model's origin too.
TEST_F(ReadFaceLoads, CoordinatesFarFromZeroAreRelativeToTheOrigin) {
    blockgen::BlockMesh mesh = io_test::two_block_mesh();
    for (Point& point : mesh.vertices) point = {point.x + 1000, point.y + 2000};
    for (auto& point : mesh.measured_points) point.position = {1002, 2002};
    blockgen::write_block_file(folder / "two.blocks", mesh);
    const std::string text = io_test::two_blocks_of_rock() + R"([joint_material.bedding]
law = "elastic"
[[line_load]]
along = [[1001, 2002], [1003, 2002]]
pressure = 1
[[head_water]]
head = [[1000, 2002]]
region = [[1000, 2000], [1004, 2000], [1004, 2001.8], [1000, 2001.8]]
[[stage]]
kind = "dynamic"
duration = 1
)";
    const Model model = read(text).model;
    ASSERT_NE(model.origin, Vec2(0, 0));
    EXPECT_EQ(std::get<LineLoad>(model.loads[0]).faces.at(0).face.edge, 8);
    EXPECT_THAT(std::get<HeadWater>(model.loads[1]).edges, ElementsAre(6, 7, 9));
    EXPECT_EQ(std::get<HeadWater>(model.loads[1]).head[0], Vec2(1000, 2002) - model.origin);
}

TEST_F(ReadFaceLoads, TheHeadMayBeTheWaterTableOfTheSection) {
    blockgen::BlockMesh mesh = io_test::two_block_mesh();
    mesh.water_table = {{0, 2}, {4, 1.5}};
    blockgen::write_block_file(folder / "two.blocks", mesh);
    const std::vector<Vec2> expected = std::get<HeadWater>(read(model_text).model.loads[3]).head;
    for (const char* head : {"", "head = \"section\"\n"}) {
        const RunInput run = read(changed("head = [[0, 2], [4, 1.5]]\n", head));
        EXPECT_EQ(std::get<HeadWater>(run.model.loads[3]).head, expected);
        EXPECT_EQ(std::get<HeadWater>(read(run.effective).model.loads[3]).head, expected);
        EXPECT_THAT(run.effective, HasSubstr("head = \"section\""));
    }
    // Runs that differ in the water table only are not taken for each other.
    const RunInput before = read(changed("head = [[0, 2], [4, 1.5]]\n", ""));
    mesh.water_table[1].y = 1.25;
    blockgen::write_block_file(folder / "two.blocks", mesh);
    EXPECT_NE(read(changed("head = [[0, 2], [4, 1.5]]\n", "")).fingerprint, before.fingerprint);
}

TEST_F(ReadFaceLoads, BadInputIsOneLineWithItsPlace) {
    EXPECT_EQ(error_with("pressure = \"3 kPa\"\npressure_end = 0\n", ""),
              "run.toml:12:1: [line_load[0]] has neither 'pressure' nor 'traction'; expected one of them");
    EXPECT_THAT(error_with("at = [2, 1.5]", "at = [2, 0.5]"), HasSubstr("no face lies on 'along'"));
    EXPECT_EQ(error_with("joint_set = \"set\"", "joint_set = \"sett\""),
              "run.toml:24:13: there is no joint_set 'sett'; expected perhaps 'set'");
    EXPECT_EQ(error_with("joint_set = \"set\"", "joint_set = \"nix\""),
              "run.toml:24:13: there is no joint_set 'nix'; expected one of set");
    EXPECT_THAT(error_with("joint_set = \"set\"", "joint_material = \"beding\""),
                HasSubstr("there is no joint_material 'beding'; expected perhaps 'bedding'"));
    EXPECT_THAT(error_with("\"5 kPa\"", "0"), HasSubstr("expected a positive number"));
    EXPECT_THAT(error_with("[4, 1.5]]", "[0, 1.5]]"), HasSubstr("expected points with increasing x"));
    EXPECT_THAT(error_with("[[0, 2], [4, 1.5]]", "[]"), HasSubstr("head"));
    EXPECT_THAT(error_with("head = [[0, 2], [4, 1.5]]\n", ""),
                HasSubstr("the block file has no water table to be the head of [head_water[0]]"));
    EXPECT_THAT(error_with("[[0, 2], [4, 1.5]]", "\"section\""),
                HasSubstr("the block file has no water table"));
    EXPECT_THAT(error_with("[[0, 2], [4, 1.5]]", "\"slope\""),
                HasSubstr("is \"slope\"; expected [[x, y], ...], or \"section\""));
    EXPECT_THAT(error_with("[[0.5, 0.5], [3.5, 0.5], [3.5, 1.8], [0.5, 1.8]]", "[[0, 0], [1, 1]]"),
                HasSubstr("expected three points or more"));
    EXPECT_THAT(error_with("[[0, 2], [4, 1.5]]", "[[0, 2], [4, 1.5]]\nunit_weight = -1"),
                HasSubstr("expected a positive number"));
    EXPECT_THAT(error_with("pressure_end = 0", "presure_end = 0"), HasSubstr("did you mean 'pressure_end'"));
}

}  // namespace
}  // namespace rockslope::dda::read_face_loads_test
