// The strength of rough joints.

#include <gtest/gtest.h>

#include "dda/joint/barton_bandis.hpp"
#include "dda/joint/shear_test.hpp"
#include "support/case_name.hpp"
#include "support/cyclic_joints.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::rough_joint_test {
namespace {

using namespace scene;
using namespace verification;

/// The granite joint of Ma et al. (2017), Table 3: JRC 12.8, JCS 151 MPa, phi_r 34.6.
dda::BartonBandis granite() {
    dda::BartonBandis law;
    law.barton = {12.8, 151e6, radians(34.6)};
    return law;
}

/// The shear stress of a joint of 1 m under a normal stress, Pa. The lower half moves at constant velocity,
/// the upper half is fixed along the joint, and both ends carry the same load.
double sheared(const dda::JointLaw& law, double normal_stress, double& frequency_step) {
    Scene s;
    s.model.gravity.setZero();
    s.model.joint_materials[0].law = law;
    s.model.block_materials[0].poissons_ratio = 0;
    const int lower = s.box({-1, -1}, 3, 1, dda::Motion::prescribed, 0, "lower");
    const int upper = s.box({0, 0}, 1, 1);
    for (const double x : {0.0, 1.0}) {
        s.model.fixed_points.push_back({s.material_point(upper, {x, 0}), true, false});
        s.model.loads.push_back(dda::PointLoad{s.material_point(upper, {x, 1}), {0, -normal_stress / 2}, {}});
    }
    Simulation sim(s);
    EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
    sim.velocity(lower)[0] = 1e-3;
    dda::Stage stage;
    stage.name = "shear";
    stage.duration = 0.5;
    stage.dynamic_coefficient = 0;
    stage.control.step = 1e-3;
    EXPECT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    frequency_step = sim.contact_frequency_step();
    double force = 0;
    for (const dda::Contact& contact : sim.state.contacts.contacts) force += std::abs(contact.shear_force);
    return force;
}

struct BartonCase {
    double normal_stress;  ///< MPa
    double strength;       ///< MPa
};

class BartonShear : public testing::TestWithParam<BartonCase> {};

// V36. Eq. (57) at four normal stresses. At 0.5 MPa the total angle is 66.3 degrees, below the cap of 70. The
// law alone gives the numbers to the last digit. With blocks the normal force has the iteration tolerance of
// 1e-6, and the displacement of 0.5 mm shortens the overlap. The error is below 0.05 %.
TEST_P(BartonShear, HasBartonsStrength) {
    const auto [normal_stress, expected] = GetParam();
    const dda::BartonBandis law = granite();
    const double alone = law.barton.shear_strength(normal_stress * 1e6, 1, 1) / 1e6;
    EXPECT_NEAR(alone, expected, 5e-5);
    double frequency_step = 0;
    const double ours = sheared(law, normal_stress * 1e6, frequency_step) / 1e6;
    Case strength("V36", "JRC = 12.8, JCS = 151 MPa, φ_r = 34.6°, σ = " + case_number(normal_stress) + " MPa",
                  "the overlap changes by 0.05 %");
    strength.contact_frequency_step(frequency_step);
    strength.expect("strength in blocks", "MPa", ours, expected, relative(.005));
    strength.expect("strength of the law", "MPa", alone, expected, absolute(5e-5));
}

std::string barton_name(const testing::TestParamInfo<BartonCase>& tested) {
    return case_name(case_number(tested.param.normal_stress) + " MPa");
}
INSTANTIATE_TEST_SUITE_P(Granite, BartonShear,
                         testing::Values(BartonCase{0.5, 1.1414}, BartonCase{1, 1.9202},
                                         BartonCase{2, 3.2814}, BartonCase{5, 6.7680}),
                         barton_name);

// V37 and V38: the law alone, driven along the path without blocks.

dda::ShearTest shear_test(const dda::JointLaw& law, double normal_stress, std::vector<double> path) {
    dda::ShearTest test;
    test.material.law = law;
    test.length = 0.1;
    test.normal_stress = normal_stress;
    test.path = std::move(path);
    test.increment = 1;
    return test;
}

void expect_two_cycles(const std::string& rock, const dda::JointLaw& law, double normal_stress, double peak,
                       const std::vector<joint_tests::QuarterCycle>& expected) {
    Case quarters("V37", rock + ", law alone, ±15 mm",
                  "0.05 % of the peak and half a digit of the reference; 0.2 µm and likewise");
    const double a = 0.015;
    const auto rows = dda::run_shear_test(shear_test(law, normal_stress, {a, 0, -a, 0, a, 0, -a, 0}));
    ASSERT_EQ(rows.size(), expected.size() + 1);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const std::string at = " after quarter " + std::to_string(k + 1);
        quarters.expect("stress" + at, "MPa", rows[k + 1].shear_stress / 1e6, expected[k].stress,
                        absolute(5e-4 * peak + 5e-5));
        quarters.expect("dilation" + at, "mm", rows[k + 1].dilation * 1e3, expected[k].dilation,
                        absolute(7e-4));
    }
}

TEST(CyclicShear, GraniteAlone) {
    expect_two_cycles("granite", joint_tests::granite(), 1e6, 1.9202, joint_tests::granite_quarters);
}

TEST(CyclicShear, MarbleAlone) {
    expect_two_cycles("marble", joint_tests::marble(), 0.5e6, 1.1306, joint_tests::marble_quarters);
}

// V38. Granite is sheared to 5 mm, back to 3 mm and to 5 mm again: the stress is linear between ratios of 0.3
// and -0.3. Then to 2.5 mm, back to 0.9 mm and to 2 mm: the strength is that of x = 2, not of x = 1.6.
TEST(CyclicShear, PartialReversals) {
    const double i = radians(12.8 * std::log10(151.));
    const auto stress = [&](double ratio) { return std::tan(radians(34.6) + ratio * i); };
    const double locked = (stress(.3) + stress(-.3)) / (stress(1) / 1.25);  // mm
    const auto rows = dda::run_shear_test(shear_test(joint_tests::granite(), 1e6, {5e-3, 3e-3, 5e-3}));
    Case closed("V38", "granite, law alone, 5 to 3 to 5 mm", "rounding");
    closed.expect("stress at 3 mm", "MPa", rows[2].shear_stress / 1e6, -stress(-.3), relative(1e-9));
    closed.expect("stress at 5 mm", "MPa", rows[3].shear_stress / 1e6, stress(.3), relative(1e-9));
    closed.expect("contraction", "mm", (rows[1].dilation - rows[2].dilation) * 1e3,
                  locked * std::tan(.3 * i) + (2 - locked) * std::tan(.3 * i), relative(1e-9));
    Case worn("V38", "granite, law alone, 2.5 to 0.9 to 2 mm", "digits of the reference");
    const auto again = dda::run_shear_test(shear_test(joint_tests::granite(), 1e6, {2.5e-3, 0.9e-3, 2e-3}));
    worn.expect("stress at 2 mm", "MPa", again[3].shear_stress / 1e6, 1.132, absolute(5e-4));
}

}  // namespace
}  // namespace rockslope::rough_joint_test
