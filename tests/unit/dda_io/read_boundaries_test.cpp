#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dda/io/find_faces.hpp"
#include "model_text_test.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;

const char* const model_text = R"(blocks = "two.blocks"
[block_material.rock]
density = 2500
youngs_modulus = "10 GPa"
poissons_ratio = 0.25
[joint_material.bedding]
law = "elastic"
normal_stiffness = "20 GPa/m"
shear_stiffness = "5 GPa/m"
corner_length = "5 cm"
[[viscous_boundary]]
name = "top"
along = [[1, 2], [2.5, 2]]
normal_impedance = 5e6
hold = "normal"
[[viscous_boundary]]
name = "side"
along = [[3, 1], [3, 2]]
[[stage]]
kind = "dynamic"
duration = 1
[[stage.incident_wave]]
boundary = "top"
x = { times = [0, 1], values = ["1 cm/s", 0], scale = 2 }
)";

class ReadBoundaries : public io_test::ModelTextTest {
  protected:
    ReadBoundaries() : ModelTextTest(model_text) {}
};

TEST_F(ReadBoundaries, EveryKeyArrives) {
    const RunInput input = read(model_text);
    const JointMaterial& joint = input.model.joint_materials[0];
    EXPECT_TRUE(std::holds_alternative<Elastic>(joint.law));
    EXPECT_EQ(joint.normal_stiffness, 2e10);
    EXPECT_EQ(joint.shear_stiffness, 5e9);
    EXPECT_EQ(joint.corner_length, 0.05);
    ASSERT_EQ(input.model.viscous_boundaries.size(), 2u);
    const ViscousBoundary& top = input.model.viscous_boundaries[0];
    ASSERT_EQ(top.faces.size(), 1u);
    // The block's top runs from (3, 2) to (1, 2); the line covers the last three quarters of it.
    EXPECT_EQ(input.model.vertices[static_cast<std::size_t>(top.faces[0].edge)], Vec2(3, 2));
    EXPECT_DOUBLE_EQ(top.faces[0].from, 0.25);
    EXPECT_DOUBLE_EQ(top.faces[0].to, 1);
    EXPECT_EQ(top.normal_impedance, 5e6);
    EXPECT_EQ(top.shear_impedance, 0);
    EXPECT_EQ(top.hold, Hold::normal);
    EXPECT_EQ(input.model.viscous_boundaries[1].hold, Hold::both);
    const IncidentWave& wave = input.stages[0].incident_waves.at(0);
    EXPECT_EQ(wave.boundary, "top");
    EXPECT_DOUBLE_EQ(wave.x.at(0), 0.02);
    EXPECT_EQ(wave.y.at(0.5), 0);
}

TEST_F(ReadBoundaries, TheEchoReadsBackToTheSame) {
    const RunInput first = read(model_text);
    const RunInput second = read(first.effective);
    EXPECT_EQ(second.model.joint_materials[0].shear_stiffness, 5e9);
    EXPECT_EQ(second.model.viscous_boundaries[0].faces[0].from, 0.25);
    EXPECT_EQ(second.stages[0].incident_waves.at(0).x.values(),
              first.stages[0].incident_waves.at(0).x.values());
}

TEST_F(ReadBoundaries, BadInputIsOneLineWithItsPlace) {
    EXPECT_EQ(
        error_with("[[1, 2], [2.5, 2]]", "[[1, 2.1], [2.5, 2.1]]"),
        "run.toml:13:9: no face lies on 'along' in [viscous_boundary[0]]; expected a line along free faces "
        "of blocks that can move");
    EXPECT_EQ(error_with("[[1, 2], [2.5, 2]]", "[[0, 0], [4, 0]]").substr(0, 30),
              "run.toml:13:9: no face lies on")
        << "the base cannot move";
    EXPECT_EQ(error_with("[[1, 2], [2.5, 2]]", "[[1, 1], [3, 1]]").substr(0, 30),
              "run.toml:13:9: no face lies on")
        << "a joint's face is no free face";
    EXPECT_THAT(error_with("[[1, 2], [2.5, 2]]", "[[1, 2], [1, 2]]"),
                HasSubstr("expected a line of two points or more"));
    EXPECT_EQ(error_with("\"side\"", "\"top\""),
              "run.toml:17:8: there are two viscous boundaries 'top'; expected another name");
    EXPECT_EQ(error_with("boundary = \"top\"", "boundary = \"tap\""),
              "run.toml:23:12: there is no viscous boundary 'tap'; expected perhaps 'top'");
    EXPECT_THAT(error_with("hold = \"normal\"", "hold = \"sides\""),
                HasSubstr("'hold' in [viscous_boundary[0]]"));
    EXPECT_THAT(error_with("= 5e6", "= -1"), HasSubstr("expected zero or a positive number"));
    EXPECT_THAT(error_with("\"20 GPa/m\"", "0"), HasSubstr("expected a positive number"));
    EXPECT_THAT(error_with("\"20 GPa/m\"", "\"20 GPa\""), HasSubstr("Pa/m"));
    EXPECT_EQ(error_with("corner_length = \"5 cm\"", "normal_penalty = 1e9"),
              "run.toml:10:18: 'normal_penalty' and 'normal_stiffness' stand together in "
              "[joint_material.bedding]; expected one of them");
    EXPECT_THAT(error_with("normal_stiffness = \"20 GPa/m\"\n", ""),
                HasSubstr("unknown key 'shear_stiffness'"));
    EXPECT_THAT(error_with("law = \"elastic\"", "law = \"elastic\"\ncohesion = 1"),
                HasSubstr("unknown key 'cohesion'"));
}

TEST(FacesOnLine, AreCutWhereTheLineEndsAndCountAlongIt) {
    Model model;
    for (const double x : {0.0, 2.0}) {
        for (const Vec2& corner : {Vec2(x, 0), Vec2(x + 2, 0), Vec2(x + 2, 1), Vec2(x, 1)})
            model.vertices.push_back(corner);
        model.topology.add_block({4});
        model.motion.push_back(Motion::free);
    }
    const std::vector<Vec2> line = {{4, 0}, {4, 1}, {1, 1}};
    const std::vector<FaceOnLine> found = faces_on_line(model, line, 1e-6);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].face.edge, 5);
    EXPECT_EQ(found[1].face.edge, 2);
    EXPECT_EQ(found[1].face.from, 0);
    EXPECT_DOUBLE_EQ(found[1].face.to, 0.5);
    EXPECT_DOUBLE_EQ(found[1].start, 3);
    EXPECT_DOUBLE_EQ(found[1].end, 4);
    EXPECT_EQ(found[2].face.edge, 6);
    EXPECT_DOUBLE_EQ(found[2].start, 1);
    EXPECT_DOUBLE_EQ(found[2].end, 3);
    model.motion[1] = Motion::fixed;
    EXPECT_EQ(faces_on_line(model, line, 1e-6).size(), 1u);
    EXPECT_TRUE(faces_on_line(model, line, 1e-6, 1).empty());
}

}  // namespace
}  // namespace dda
