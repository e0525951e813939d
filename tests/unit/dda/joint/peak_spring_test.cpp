#include "dda/joint/peak_spring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockslope::peak_spring_test {
namespace {

using dda::PeakSpring;

constexpr double degree = std::numbers::pi / 180;
constexpr double peak_displacement = 5e-3;

dda::BartonStrength rough() {
    dda::BartonStrength barton;
    barton.residual_friction_angle = 25 * degree;
    barton.roughness_coefficient = 4;
    barton.wall_strength = 1e8;
    return barton;
}

PeakSpring after(const PeakSpring& spring, double normal_force, double length) {
    return spring.loaded({normal_force, length, length, true}, rough(), peak_displacement);
}
PeakSpring shaken(const PeakSpring& spring, double normal_force, double length) {
    return spring.loaded({normal_force, length, length, false}, rough(), peak_displacement);
}

TEST(PeakSpring, TakesTheJointToItsPeakStrengthAtThePeakDisplacement) {
    const PeakSpring spring = after({}, 1e6, 10);
    // 0.1 MPa: 25 + 4 * 3 = 37 degrees.
    EXPECT_NEAR(spring.stiffness_of_part(10), 1e6 * std::tan(37 * degree) / peak_displacement, 1e-6 * 1e8);
    EXPECT_NEAR(spring.stiffness_of_part(4) + spring.stiffness_of_part(6), spring.stiffness_of_part(10),
                1e-6);
}

TEST(PeakSpring, IsThatOfTheLargestForce) {
    const PeakSpring loaded = after({}, 2e6, 10);
    EXPECT_EQ(after(loaded, 1e6, 10), loaded) << "unloading";
    EXPECT_EQ(after(after({}, 1e6, 10), 2e6, 10), loaded) << "in two parts";
}

TEST(PeakSpring, OfAJointThatWasAtRestStaysWhenItIsShaken) {
    const PeakSpring found_at_rest = after({}, 1e6, 10);
    EXPECT_EQ(shaken(found_at_rest, 3e6, 10), found_at_rest);
    const PeakSpring fresh = shaken(shaken({}, 1e6, 10), 3e6, 10);
    EXPECT_EQ(fresh.stiffness_of_part(10), after({}, 3e6, 10).stiffness_of_part(10))
        << "it was never at rest";
    EXPECT_EQ(after(fresh, 1e6, 10).stiffness_of_part(10), fresh.stiffness_of_part(10)) << "it comes to rest";
}

// A landing strikes harder than the joint bore at rest.
TEST(PeakSpring, IsFoundAnewWhereAnOpenJointLands) {
    PeakSpring landed = after({}, 1e6, 10);
    landed.leave_rest();
    EXPECT_EQ(shaken(landed, 5e5, 10).stiffness_of_part(10), landed.stiffness_of_part(10)) << "softly";
    EXPECT_EQ(shaken(landed, 3e6, 10).stiffness_of_part(10), after({}, 3e6, 10).stiffness_of_part(10));
}

// The overlap of two faces shrinks; what the spring was found at does not.
TEST(PeakSpring, KeepsTheForceThatItWasFoundAt) {
    const PeakSpring slid_off = after(after({}, 1e6, 10), 5e5, 2);
    EXPECT_EQ(slid_off.normal_force, 1e6);
    EXPECT_EQ(slid_off.normal_stress, 1e5);
}

// Faces that met with a sliver of their length: a spring kept per length would be a billion times as stiff
// on the whole length.
TEST(PeakSpring, BelongsToTheJointWhateverItsLength) {
    const PeakSpring grazed = after({}, 1e6, 1e-8);
    const double least = 1e6 * std::tan(25 * degree) / peak_displacement;
    EXPECT_NEAR(grazed.stiffness_of_part(1e-8), least, 1e-6 * least)
        << "above the wall strength: no roughness";
    EXPECT_EQ(grazed.stiffness_of_part(10), grazed.stiffness_of_part(1e-8)) << "the length has grown since";
    const PeakSpring flush = after(grazed, 1e6, 10);
    EXPECT_EQ(flush.stiffness_of_part(10), after({}, 1e6, 10).stiffness_of_part(10));
    const PeakSpring slid_off = after(flush, 1e6, 0.1);
    EXPECT_EQ(slid_off.stiffness_of_part(0.1), flush.stiffness_of_part(10))
        << "what is left of the overlap bears it";
}

TEST(PeakSpring, IsZeroWithoutForceLengthOrPeak) {
    EXPECT_EQ(after({}, 0, 10), PeakSpring{});
    EXPECT_EQ(after({}, 1e6, 0), PeakSpring{}) << "a bare corner";
    const PeakSpring without_peak = PeakSpring{}.loaded({1e6, 10, 10, true}, rough(), 0);
    EXPECT_EQ(without_peak.stiffness_of_part(10), 0) << "strength at once";
    EXPECT_EQ(without_peak.normal_stress, 1e5) << "for the dilation in flight";
    EXPECT_EQ(PeakSpring{}.stiffness_of_part(1), 0);
}

}  // namespace
}  // namespace rockslope::peak_spring_test
