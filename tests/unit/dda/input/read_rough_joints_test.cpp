#include <gmock/gmock.h>

#include "unit/dda/input/model_text.hpp"

namespace rockslope::dda::read_rough_joints_test {
namespace {

using testing::HasSubstr;

const std::string model_text = R"(blocks = "two.blocks"
[block_material.rock]
density = 2600
youngs_modulus = "5 GPa"
poissons_ratio = 0.25
[joint_material.bedding]
law = "barton-bandis"
residual_friction_angle = "34.6 deg"
jrc = 12.8
jcs = "151 MPa"
peak_displacement = "1.25 mm"
mobilisation = [[0, 1], [1, 1], [2, 0.5]]
damage = 1
[[stage]]
name = "settle"
kind = "static"
)";

class ReadRoughJoints : public io_test::ModelTextTest {
  protected:
    ReadRoughJoints() : ModelTextTest(model_text) {}
    BartonBandis barton(const std::string& text) const {
        return std::get<BartonBandis>(read(text).model.joint_materials[0].law);
    }
};

TEST_F(ReadRoughJoints, ReadsBartonBandisWithItsTable) {
    const BartonBandis law = barton(model_text);
    EXPECT_EQ(law.barton.roughness_coefficient, 12.8);
    EXPECT_EQ(law.barton.wall_strength, 151e6);
    EXPECT_NEAR(law.barton.residual_friction_angle, 0.60388392, 1e-8);
    EXPECT_EQ(law.peak_displacement, 1.25e-3);
    EXPECT_EQ(law.damage, 1);
    EXPECT_FALSE(law.from_zero_angle);
    EXPECT_EQ(law.mobilisation, (RoughnessTable{{{0, 1}, {1, 1}, {2, 0.5}}}));
}

TEST_F(ReadRoughJoints, TheCurveOfBarton1985IsTheDefault) {
    for (const char* line : {"", "mobilisation = \"barton-1985\"\n"}) {
        const BartonBandis law = barton(changed("mobilisation = [[0, 1], [1, 1], [2, 0.5]]\n", line));
        EXPECT_TRUE(law.from_zero_angle);
        EXPECT_EQ(law.mobilisation, barton_1985());
    }
}

TEST_F(ReadRoughJoints, BadValuesAreRefusedWithTheirPlace) {
    EXPECT_EQ(
        error_with("jrc = 12.8", "jrc = 21"),
        "run.toml:9:7: 'jrc' in [joint_material.bedding] is 21; expected a joint roughness coefficient from "
        "0 to 20");
    EXPECT_THAT(error_with("jrc = 12.8", "jrc = -1"), HasSubstr("from 0 to 20"));
    EXPECT_THAT(error_with("jrc = 12.8", ""), HasSubstr("jrc"));
    EXPECT_THAT(error_with("\"151 MPa\"", "0"),
                HasSubstr("'jcs' in [joint_material.bedding] is 0; expected a positive"));
    EXPECT_THAT(error_with("34.6 deg", "75 deg"), HasSubstr("expected at most 70 deg"));
    EXPECT_THAT(error_with("34.6 deg", "-1 deg"), HasSubstr("from 0 up to 90 deg"));
    EXPECT_THAT(error_with("\"1.25 mm\"", "0"), HasSubstr("expected a positive number"));
    for (const char* damage : {"0.5", "2.1", "-1"})
        EXPECT_THAT(error_with("damage = 1", std::string("damage = ") + damage), HasSubstr("'damage'"))
            << damage;
    EXPECT_THAT(error_with("damage = 1", "damge = 1"), HasSubstr("did you mean 'damage'?"));
}

TEST_F(ReadRoughJoints, BadTablesAreRefused) {
    const auto error_of_table = [&](const std::string& table) {
        return error_with("[[0, 1], [1, 1], [2, 0.5]]", table);
    };
    EXPECT_THAT(error_of_table("[]"), HasSubstr("'mobilisation' in [joint_material.bedding] is empty"));
    EXPECT_THAT(error_of_table("[[0, 1], [0, 0.5]]"), HasSubstr("has the entry [0, 0.5]"));
    EXPECT_THAT(error_of_table("[[-1, 1]]"), HasSubstr("start at 0 or above and grow"));
    EXPECT_THAT(error_of_table("[[0, 1.1]]"), HasSubstr("a mobilised ratio from -1 to 1"));
    EXPECT_THAT(error_of_table("[[0, 1, 2]]"), HasSubstr("mobilisation"));
    EXPECT_THAT(error_of_table("\"barton-1986\""), HasSubstr("barton-1985"));
}

// --- the cyclic joint

const std::string cyclic_text = R"(blocks = "two.blocks"
[block_material.rock]
density = 2600
youngs_modulus = "5 GPa"
poissons_ratio = 0.25
[joint_material.bedding]
law = "cyclic-barton-bandis"
residual_friction_angle = "34.6 deg"
jrc = 12.8
jcs = "151 MPa"
peak_displacement = "1.25 mm"
damage = 1
[[joint_material.bedding.cycle]]
forward_advance = [[0, 0], [1, 1], [2, 0.5]]
forward_return = [[0, -0.4], [2, -0.3]]
backward_advance = [[1, 0.5], [4, 0.4]]
backward_return = [[1, -0.4], [4, -0.3]]
[[stage]]
name = "settle"
kind = "static"
)";

class ReadCyclicJoint : public io_test::ModelTextTest {
  protected:
    ReadCyclicJoint() : ModelTextTest(cyclic_text) {}
    CyclicBartonBandis cyclic(const std::string& text) const {
        return std::get<CyclicBartonBandis>(read(text).model.joint_materials[0].law);
    }
    std::string with(const std::string& line) const { return changed("damage = 1", "damage = 1\n" + line); }
    std::string error_with_line(const std::string& line) const {
        return error_with("damage = 1", "damage = 1\n" + line);
    }
};

TEST_F(ReadCyclicJoint, ReadsTablesAndDefaults) {
    const CyclicBartonBandis law = cyclic(cyclic_text);
    ASSERT_EQ(law.cycles.size(), 1u);
    EXPECT_EQ(law.cycles[0].forward_advance, (RoughnessTable{{{0, 0}, {1, 1}, {2, 0.5}}}));
    EXPECT_EQ(law.cycles[0].backward_advance, (RoughnessTable{{{0, -0.4}, {1, 0.5}, {4, 0.4}}}))
        << "starts at the end of the forward return";
    EXPECT_EQ(law.cycles[0].backward_return, (RoughnessTable{{{1, -0.4}, {4, -0.3}}}));
    EXPECT_EQ(law.peak_displacement, 1.25e-3);
    EXPECT_EQ(law.min_slip, 1e-4);
    EXPECT_EQ(law.reversal_factor, 1);
    EXPECT_EQ(law.further_cycle_factor, 1);
    EXPECT_EQ(law.contact_length, 0);
    EXPECT_FALSE(law.heal || law.unsigned_ratios || law.asymmetric || law.floor_dilation);
}

TEST_F(ReadCyclicJoint, ReadsOptions) {
    EXPECT_EQ(cyclic(with("bridge = \"clamp\"")).cycles[0].backward_advance,
              (RoughnessTable{{{1, 0.5}, {4, 0.4}}}));
    EXPECT_TRUE(cyclic(with("heal = true")).heal);
    EXPECT_TRUE(cyclic(with("floor_dilation = true")).floor_dilation);
    EXPECT_EQ(cyclic(with("min_slip = \"1 mm\"")).min_slip, 1e-3);
    EXPECT_EQ(cyclic(with("reversal_factor = 0.9")).reversal_factor, 0.9);
    EXPECT_EQ(cyclic(with("further_cycle_factor = 0.8")).further_cycle_factor, 0.8);
    EXPECT_EQ(cyclic(with("contact_length = 25.1")).contact_length, 25.1);
}

TEST_F(ReadCyclicJoint, OneTableOfWearServesAllBranches) {
    std::string text = cyclic_text;
    const std::size_t from = text.find("[[joint_material"), to = text.find("[[stage]]");
    text.replace(from, to - from, "wear = [[0, 1], [20, -0.2]]\nasymmetric = true\n");
    const CyclicBartonBandis law = cyclic(text);
    const RoughnessTable wear = {{{0, 1}, {20, 0.2}}};
    ASSERT_EQ(law.cycles.size(), 1u);
    EXPECT_EQ(law.cycles[0].forward_return, wear);
    EXPECT_EQ(law.cycles[0].backward_advance, wear);
    EXPECT_TRUE(law.unsigned_ratios && law.asymmetric);
}

TEST_F(ReadCyclicJoint, TheEffectiveModelReadsBackToTheSame) {
    const RunInput input = read(with("reversal_factor = 0.9"));
    const auto& first = std::get<CyclicBartonBandis>(input.model.joint_materials[0].law);
    const CyclicBartonBandis again = cyclic(input.effective);
    EXPECT_EQ(again.cycles[0].backward_advance, first.cycles[0].backward_advance);
    EXPECT_EQ(again.reversal_factor, 0.9);
    EXPECT_EQ(again.barton.residual_friction_angle, first.barton.residual_friction_angle);
}

TEST_F(ReadCyclicJoint, BadValuesAreRefused) {
    EXPECT_THAT(error_with("\"1.25 mm\"", "0"), HasSubstr("'peak_displacement'"));
    EXPECT_THAT(error_with("peak_displacement = \"1.25 mm\"\n", ""), HasSubstr("peak_displacement"));
    EXPECT_THAT(error_with_line("reversal_factor = 1.1"), HasSubstr("expected a factor from 0 to 1"));
    EXPECT_THAT(error_with_line("further_cycle_factor = -0.1"), HasSubstr("expected a factor from 0 to 1"));
    EXPECT_THAT(error_with_line("min_slip = -1"), HasSubstr("zero or a positive number"));
    EXPECT_THAT(error_with_line("contact_length = -1"), HasSubstr("zero or a positive number"));
    EXPECT_THAT(error_with_line("bridge = \"clmp\""), HasSubstr("clamp"));
    EXPECT_THAT(error_with_line("heal = 1"), HasSubstr("heal"));
    EXPECT_THAT(error_with_line("asymmetric = true"), HasSubstr("unknown key 'asymmetric'"))
        << "requires 'wear'";
    EXPECT_THAT(error_with_line("wear = [[0, 1]]"), HasSubstr("cycle")) << "either 'cycle' or 'wear'";
    EXPECT_THAT(error_with("[[0, -0.4], [2, -0.3]]", "[[2, -0.4], [1, -0.3]]"),
                HasSubstr("'forward_return' in [joint_material.bedding.cycle[0]] has the entry [1, -0.3]"));
    EXPECT_THAT(error_with("backward_return = [[1, -0.4], [4, -0.3]]", ""), HasSubstr("backward_return"));
}

// --- weakening and asperities: the table of the law replaces that of the model text

class ReadWornJoints : public io_test::ModelTextTest {
  protected:
    ReadWornJoints() : ModelTextTest(model_text) {}
    std::string with_law(const std::string& lines) const {
        std::string text = model_text;
        const std::size_t from = text.find("law ="), to = text.find("[[stage]]");
        return text.replace(from, to - from, lines);
    }
    template <class Law>
    Law law(const std::string& lines) const {
        return std::get<Law>(read(with_law(lines)).model.joint_materials[0].law);
    }
    std::string error(const std::string& lines) const {
        return io_test::error_of([&] { read(with_law(lines)); });
    }
};

TEST_F(ReadWornJoints, ReadsWeakeningAndBilinear) {
    const std::string text =
        "law = \"weakening\"\nfriction_angle = \"0.5 rad\"\nresidual_friction_angle = "
        "\"0.3 rad\"\ncohesion = 2e5\nresidual_cohesion = 1e4\nweakening_slip = \"5 mm\"\n";
    const auto weakening = law<Weakening>(text + "weakening = \"exponential\"\n");
    EXPECT_EQ(weakening.friction_angle, 0.5);
    EXPECT_EQ(weakening.residual_friction_angle, 0.3);
    EXPECT_EQ(weakening.cohesion, 2e5);
    EXPECT_EQ(weakening.residual_cohesion, 1e4);
    EXPECT_EQ(weakening.slip, 5e-3);
    EXPECT_TRUE(weakening.exponential);
    EXPECT_FALSE(law<Weakening>(text).exponential);
    EXPECT_THAT(error(text + "weakening = \"cubic\"\n"), HasSubstr("exponential"));
    const std::string start = "law = \"weakening\"\nfriction_angle = \"0.5 rad\"\n";
    EXPECT_THAT(error(start), HasSubstr("weakening_slip"));
    EXPECT_THAT(error(start + "weakening_slip = 0\n"), HasSubstr("expected a positive number"));
    EXPECT_THAT(error(start + "weakening_slip = 1\nresidual_friction_angle = \"0.6 rad\"\n"),
                HasSubstr("an angle up to 'friction_angle'"));
    EXPECT_THAT(error(start + "weakening_slip = 1\nresidual_cohesion = 1\n"),
                HasSubstr("a stress up to 'cohesion'"));
    const auto teeth = law<Bilinear>(
        "law = \"bilinear\"\nfriction_angle = \"0.8 rad\"\nresidual_friction_angle "
        "= \"0.5 rad\"\ntransition_stress = \"2 MPa\"\n");
    EXPECT_EQ(teeth.transition_stress, 2e6);
    EXPECT_EQ(teeth.residual_friction_angle, 0.5);
    EXPECT_THAT(error("law = \"bilinear\"\nfriction_angle = \"0.8 rad\"\ntransition_stress = -1\n"),
                HasSubstr("zero or a positive number"));
}

TEST_F(ReadWornJoints, ReadsVelocityWeakening) {
    const std::string start =
        "law = \"velocity-weakening\"\nfriction_angle = \"0.5 rad\"\nresidual_friction_angle = \"0.3 rad\"\n";
    const auto smooth = law<VelocityWeakening>(start + "weakening_speed = \"10 cm/s\"\n");
    EXPECT_EQ(smooth.residual_friction_angle, 0.3);
    EXPECT_EQ(smooth.speed, 0.1);
    EXPECT_EQ(smooth.rate, 0);
    const std::string logarithmic = start + "weakening_speed = 1e-3\nweakening = \"logarithmic\"\n";
    EXPECT_EQ(law<VelocityWeakening>(logarithmic + "weakening_rate = 0.02\n").rate, 0.02);
    EXPECT_THAT(error(start), HasSubstr("weakening_speed"));
    EXPECT_THAT(error(start + "weakening_speed = 0\n"), HasSubstr("expected a positive number"));
    EXPECT_THAT(error(start + "weakening_speed = 1\nweakening = \"linear\"\n"), HasSubstr("logarithmic"));
    EXPECT_THAT(error(start + "weakening_speed = 1\nweakening_rate = 0.02\n"),
                HasSubstr("unknown key 'weakening_rate'"))
        << "the exponential law has none";
    EXPECT_THAT(error(logarithmic), HasSubstr("weakening_rate"));
    EXPECT_THAT(error(logarithmic + "weakening_rate = -1\n"), HasSubstr("expected a positive number"));
}

TEST_F(ReadWornJoints, ReadsContinuouslyYielding) {
    const std::string start =
        "law = \"continuously-yielding\"\nfriction_angle = \"0.5 rad\"\nresidual_friction_angle = \"0.3 "
        "rad\"\n";
    const auto joint = law<ContinuouslyYielding>(start + "roughness_length = \"2 mm\"\n");
    EXPECT_EQ(joint.friction_angle, 0.5);
    EXPECT_EQ(joint.residual_friction_angle, 0.3);
    EXPECT_EQ(joint.roughness_length, 2e-3);
    EXPECT_THAT(error(start), HasSubstr("roughness_length"));
    EXPECT_THAT(error(start + "roughness_length = 0\n"), HasSubstr("expected a positive number"));
    EXPECT_THAT(error("law = \"continuously-yielding\"\nfriction_angle = \"0.5 rad\"\nroughness_length = 1\n"
                      "residual_friction_angle = \"0.6 rad\"\n"),
                HasSubstr("an angle up to 'friction_angle'"));
}

TEST_F(ReadWornJoints, ReadsAsperities) {
    const std::string friction = "friction_angle = \"0.5 rad\"\n";
    const auto plesha =
        law<Plesha>("law = \"plesha\"\n" + friction + "asperity_angle = \"0.2 rad\"\nwear = 1e-4\n");
    EXPECT_EQ(plesha.asperity_angle, 0.2);
    EXPECT_EQ(plesha.wear, 1e-4);
    const auto two = law<TwoOrderAsperities>("law = \"two-order-asperities\"\n" + friction +
                                             "waviness_angle = \"0.1 rad\"\nunevenness_angle = \"0.3 rad\"\n"
                                             "waviness_wear = 1e-5\nunevenness_wear = 1e-3\n");
    EXPECT_EQ(two.waviness_wear, 1e-5);
    EXPECT_EQ(two.unevenness_angle, 0.3);
    const auto stressed =
        law<StressedAsperities>("law = \"stressed-asperities\"\n" + friction +
                                "asperity_angle = \"0.2 rad\"\nwall_strength = \"50 MPa\"\n");
    EXPECT_EQ(stressed.wall_strength, 50e6);
    EXPECT_EQ(stressed.exponent, 1);
    EXPECT_THAT(error("law = \"plesha\"\n" + friction + "asperity_angle = \"1.1 rad\"\n"),
                HasSubstr("leaves the sum with friction below 90 deg"));
    EXPECT_THAT(error("law = \"plesha\"\n" + friction + "asperity_angle = \"0.2 rad\"\nwear = -1\n"),
                HasSubstr("zero or a positive number"));
    EXPECT_THAT(error("law = \"two-order-asperities\"\n" + friction +
                      "waviness_angle = \"0.6 rad\"\nunevenness_angle = \"0.6 rad\"\n"),
                HasSubstr("'unevenness_angle'"));
    EXPECT_THAT(error("law = \"stressed-asperities\"\n" + friction +
                      "asperity_angle = \"0.2 rad\"\nwall_strength = 1e6\nexponent = 0\n"),
                HasSubstr("'exponent'"));
}

}  // namespace
}  // namespace rockslope::dda::read_rough_joints_test
