#include <gmock/gmock.h>

#include "model_text_test.hpp"

namespace dda {
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

TEST_F(ReadRoughJoints, BartonBandisComesInWithItsTable) {
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

}  // namespace
}  // namespace dda
