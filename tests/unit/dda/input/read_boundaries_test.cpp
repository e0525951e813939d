#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dda/input/find_faces.hpp"
#include "unit/dda/input/model_text.hpp"

namespace rockslope::dda::read_boundaries_test {
namespace {

using ::testing::Eq;
using ::testing::HasSubstr;

const std::string model_text = io_test::two_blocks_of_rock() + R"([joint_material.bedding]
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

TEST_F(ReadBoundaries, ReadsEveryKey) {
    const RunInput input = read(model_text);
    const JointMaterial& joint = input.model.joint_materials[0];
    EXPECT_TRUE(std::holds_alternative<Elastic>(joint.law));
    EXPECT_EQ(joint.normal_stiffness, 2e10);
    EXPECT_EQ(joint.shear_stiffness, 5e9);
    EXPECT_EQ(joint.corner_length, 0.05);
    EXPECT_EQ(joint.largest_closure, 0) << "linear";
    const std::string stiffness = "corner_length = \"5 cm\"\n";
    const RunInput closing = read(changed(stiffness, stiffness + "largest_closure = \"0.2 mm\"\n"));
    EXPECT_DOUBLE_EQ(closing.model.joint_materials[0].largest_closure, 2e-4);
    ASSERT_EQ(input.model.viscous_boundaries.size(), 2u);
    const ViscousBoundary& top = input.model.viscous_boundaries[0];
    ASSERT_EQ(top.faces.size(), 1u);
    // The block's top runs from (3, 2) to (1, 2); the line covers the last three quarters of it.
    EXPECT_EQ(input.model.vertices[start_of(top.faces[0].edge)], Vec2(3, 2));
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

TEST_F(ReadBoundaries, TheEffectiveModelReadsBackToTheSame) {
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
        << "the face of a joint is not free";
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
              "run.toml:10:18: 'normal_penalty' and 'normal_stiffness' are both given in "
              "[joint_material.bedding]; expected one of them");
    EXPECT_THAT(error_with("corner_length = \"5 cm\"", "largest_closure = 0"),
                HasSubstr("expected a positive number"));
    EXPECT_THAT(error_with("normal_stiffness = \"20 GPa/m\"\n", ""),
                HasSubstr("has no 'normal_stiffness' beside it; expected both"));
    EXPECT_THAT(error_with("law = \"elastic\"", "law = \"elastic\"\ncohesion = 1"),
                HasSubstr("unknown key 'cohesion'"));
}

TEST_F(ReadBoundaries, ContactsThatGiveWayMayBeDamped) {
    EXPECT_EQ(read(model_text).model.joint_materials[0].contact_damping, 0);
    const std::string law = "law = \"elastic\"\n";
    const RunInput damped = read(changed(law, law + "contact_damping = 0.2\n"));
    EXPECT_EQ(damped.model.joint_materials[0].contact_damping, 0.2);
    EXPECT_EQ(read(damped.effective).model.joint_materials[0].contact_damping, 0.2);
    EXPECT_EQ(error_with(law, law + "contact_damping = -0.1\n"),
              "run.toml:8:19: 'contact_damping' in [joint_material.bedding] is -0.1; expected zero or a "
              "positive number");
    for (const char* value : {"inf", "nan", "1e31"})
        EXPECT_THAT(error_with(law, law + "contact_damping = " + value + "\n"), HasSubstr("run.toml:8:19: "));
    // A joint with a stiffness of its own gives way whatever the tolerance.
    const std::string augmented = "[analysis]\npenetration_tolerance = 1e-6\n";
    const std::string own =
        "normal_stiffness = \"20 GPa/m\"\nshear_stiffness = \"5 GPa/m\"\n"
        "corner_length = \"5 cm\"\n";
    EXPECT_EQ(read(changed(own, own + "contact_damping = 0.2\n" + augmented)).model.penetration_tolerance,
              1e-6);
    EXPECT_THAT(error_with(own, "contact_damping = 0.2\n" + augmented),
                HasSubstr("'penetration_tolerance' makes contacts rigid, and 'contact_damping' of "
                          "[joint_material.bedding] damps contacts that give way; expected one of them"));
}

TEST_F(ReadBoundaries, AFreeFieldNeedsAnUprightSide) {
    const std::string side = "along = [[3, 1], [3, 2]]";
    const RunInput input = read(changed(side, side + "\nfree_field = \"top\"\nfree_field_layer = \"40 cm\""));
    EXPECT_FALSE(input.model.viscous_boundaries[0].free_field);
    const FreeField& field = input.model.viscous_boundaries[1].free_field.value();
    EXPECT_EQ(field.base_boundary, "top");
    ASSERT_EQ(field.nodes.size(), 4u) << "1 m in layers of 40 cm or less";
    EXPECT_DOUBLE_EQ(field.nodes.front(), 1);
    EXPECT_DOUBLE_EQ(field.nodes.back(), 2);
    EXPECT_EQ(field.rock, (std::vector<dda::BlockIndex>{1, 1, 1}));
    const auto refused = [&](const std::string& keys) { return error_with(side, side + "\n" + keys); };
    EXPECT_EQ(refused("free_field = \"tip\""),
              "run.toml:19:14: there is no viscous boundary 'tip'; expected perhaps 'top'");
    EXPECT_THAT(refused("free_field = \"side\""), HasSubstr("has a free field"));
    EXPECT_THAT(refused("free_field = \"\""), HasSubstr("'free_field' is empty"));
    EXPECT_THAT(refused("free_field_layer = 1"), HasSubstr("unknown key 'free_field_layer'"));
    EXPECT_THAT(refused("free_field = \"top\"\nfree_field_layer = -1"),
                HasSubstr("expected zero or a positive number"));
    EXPECT_THAT(refused("free_field = \"top\"\nfree_field_layer = 1e-9"), HasSubstr("too thin"));
    EXPECT_THAT(error_with("hold = \"normal\"", "free_field = \"side\""), HasSubstr("not upright"));
    EXPECT_THAT(error_with("boundary = \"top\"\n", "boundary = \"side\"\n"), Eq("no error"));
    const std::string both = changed(side, side + "\nfree_field = \"top\"");
    const auto at = both.find("boundary = \"top\"");
    std::string onto_side = both;
    onto_side.replace(at, 16, "boundary = \"side\"");
    EXPECT_THAT(io_test::error_of([&] { read(onto_side); }), HasSubstr("so no wave can enter through it"));
}

TEST_F(ReadBoundaries, AWaveIsAVelocityAStressOrARecord) {
    const std::string table = "x = { times = [0, 1], values = [\"1 cm/s\", 0], scale = 2 }";
    const auto wave = [&](const std::string& text) {
        return read(changed(table, text)).stages[0].incident_waves.at(0);
    };
    const IncidentWave late = wave("delay = \"50 ms\"\n" + table);
    EXPECT_DOUBLE_EQ(late.x.times()[0], 0.05);
    EXPECT_DOUBLE_EQ(late.x.values()[0], 0.02);
    EXPECT_FALSE(late.x_is_traction);
    const IncidentWave stress =
        wave("y = { times = [0, 1], values = [\"1 kPa\", 0], scale = 3, quantity = \"stress\" }");
    EXPECT_TRUE(stress.y_is_traction);
    EXPECT_FALSE(stress.x_is_traction);
    EXPECT_DOUBLE_EQ(stress.y.values()[0], 3000);
    // 0, 1, 2, 1, 0 gal at 0.1 s, integrated by the trapezoidal rule.
    folder.write("a.csv", "0,0\n0.1,1\n0.2,2\n0.3,1\n0.4,0\n");
    const IncidentWave integrated =
        wave("x = { file = \"a.csv\", quantity = \"acceleration\", unit = \"gal\", scale = 10 }");
    ASSERT_EQ(integrated.x.values().size(), 5u);
    EXPECT_NEAR(integrated.x.values()[1], 0.1 * 0.05, 1e-15);
    EXPECT_NEAR(integrated.x.values()[4], 0.1 * 0.4, 1e-15);
    EXPECT_EQ(wave("x = { file = \"a.csv\" }").x.values()[1], 1) << "two columns are m/s";
    EXPECT_THAT(error_with(table, "delay = -1\n" + table), HasSubstr("'delay'"));
    EXPECT_THAT(error_with("scale = 2", "quantity = \"speed\""), HasSubstr("'quantity'"));
    EXPECT_THAT(error_with("scale = 2", "scale = 1e300"), HasSubstr("too large"));
    folder.write("d.csv", "time (s),displacement (m)\n0,0\n0.1,1\n0.2,2\n");
    EXPECT_THAT(error_with(table, "x = { file = \"d.csv\", quantity = \"displacement\" }"),
                HasSubstr("at least 5 to differentiate"));
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
    const std::vector<FaceAlongLine> found = faces_along_line(model, line, 1e-6);
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
    EXPECT_EQ(faces_along_line(model, line, 1e-6).size(), 1u);
    EXPECT_TRUE(faces_along_line(model, line, 1e-6, 1).empty());
}

}  // namespace
}  // namespace rockslope::dda::read_boundaries_test
