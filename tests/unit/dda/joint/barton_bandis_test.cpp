#include "dda/joint/barton_bandis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cyclic_joints.hpp"

namespace rockslope::barton_bandis_test {
namespace {

using dda::BartonBandis;
using dda::ContactMotion;
using joint_tests::flight;
using joint_tests::granite_peak;

constexpr double degree = 0.017453292519943295;
constexpr double force = 1e5, length = 0.1;  // 1 MPa

BartonBandis barton_1985_granite(double damage = 1) {
    return {joint_tests::granite_strength(), granite_peak, dda::barton_1985(), true, damage};
}
BartonBandis::History after(const BartonBandis& law, double displacement) {
    return law.advance(law.fresh(true), {displacement, displacement, force, length, false, 0, 0});
}
double stress_at(const BartonBandis& law, double x) {
    return law.strength(after(law, x * granite_peak), force, length, {}).forward / length;
}

TEST(BartonBandis, WithoutAPeakDisplacementTheRoughnessStays) {
    const BartonBandis law{joint_tests::granite_strength(), 0, {}, false, 0};
    EXPECT_NEAR(law.strength(law.fresh(true), force, length, {}).forward, 1.92024e5, 0.5);
    EXPECT_NEAR(law.strength(after(law, 1), force, length, {}).forward, 1.92024e5, 0.5);
    EXPECT_EQ(law.shear_stiffness(law.fresh(true), force, length), 0);
}

// The curve of Barton (1985): nothing at 0, phi_r at 0.3, the peak at 1, then softening to phi_r at 100.
TEST(BartonBandis, MobilisesRoughnessAsInBarton1985) {
    const BartonBandis law = barton_1985_granite();
    const auto tangent = [](double degrees) { return 1e6 * std::tan(degrees * degree); };
    EXPECT_EQ(stress_at(law, 0), 0);
    EXPECT_NEAR(stress_at(law, 0.15), tangent(34.6 / 2), 1);
    EXPECT_NEAR(stress_at(law, 0.3), tangent(34.6), 1);
    EXPECT_NEAR(stress_at(law, 0.6), tangent(34.6 + 0.75 * 27.89091), 20);
    EXPECT_NEAR(stress_at(law, 1), 1.92024e6, 5);
    EXPECT_NEAR(stress_at(law, 3), tangent(34.6 + 0.775 * 27.89091), 20);
    EXPECT_NEAR(stress_at(law, 100), tangent(34.6), 1);
    EXPECT_NEAR(stress_at(law, 1000), tangent(34.6), 1);
}

TEST(BartonBandis, MobilisedRoughnessStaysOnReversal) {
    const BartonBandis law = barton_1985_granite();
    const auto there = after(law, 2 * granite_peak);
    const auto back = law.advance(there, {-3 * granite_peak, -3 * granite_peak, force, length, false, 0, 0});
    EXPECT_EQ(law.strength(back, force, length, {}).backward, law.strength(there, force, length, {}).forward);
    EXPECT_EQ(back.dilation, there.dilation) << "it slipped all the way";
}

// The spring of Eq. (58) reaches the strength at the peak displacement.
TEST(BartonBandis, SpringReachesThePeakAtThePeakDisplacement) {
    const BartonBandis law = barton_1985_granite();
    const double k = law.shear_stiffness(law.fresh(true), force, length);
    EXPECT_NEAR(k, 1.92024e5 / 1.25e-3, 1e3);
    const auto loaded = law.advance(law.fresh(true), {0, 0, force, length, false, 0, k});
    EXPECT_EQ(law.shear_stiffness(loaded, 3 * force, length), k) << "it stays what it was at first";
}

// A spring softer than the rising curve does not reach the strength on it; its force is the smaller one of
// Eq. (62).
TEST(BartonBandis, TrialStrengthIsTheLowestAlongTheDisplacement) {
    const BartonBandis law = barton_1985_granite();
    const double far = 4 * granite_peak, k = 1e12;  // stiff: the force follows the curve down to x = 4
    EXPECT_NEAR(law.strength(law.fresh(true), force, length, {far, 0, k}).forward / length, stress_at(law, 4),
                1);
    const auto inside = after(law, 0.5 * granite_peak);
    const double soft = 1e7;  // slower than the curve rises
    const auto s = law.strength(inside, force, length, {0.1 * granite_peak, 0, soft});
    EXPECT_NEAR(s.forward, stress_at(law, 0.5) * length + soft * 0.1 * granite_peak, 1e-6);
}

// Dilation begins at x = 0.3. From there to 0.6 the angle rises from 0 to 0.75 i, then to i at 1.
TEST(BartonBandis, DilatesByTheMobilisedRoughness) {
    const double i = 27.89091 * degree;
    const auto mean = [](double a, double b) {
        return (std::log(std::cos(a)) - std::log(std::cos(b))) / (b - a);
    };
    const double expected = granite_peak * (0.3 * mean(0, 0.75 * i) + 0.4 * mean(0.75 * i, i));
    EXPECT_NEAR(after(barton_1985_granite(), granite_peak).dilation, expected, 1e-9);
    EXPECT_EQ(after(barton_1985_granite(), 0.3 * granite_peak).dilation, 0);
    EXPECT_EQ(after(barton_1985_granite(0), granite_peak).dilation, 0);
    const double half = granite_peak * (0.3 * mean(0, 0.375 * i) + 0.4 * mean(0.375 * i, 0.5 * i));
    EXPECT_NEAR(after(barton_1985_granite(2), granite_peak).dilation, half, 1e-9) << "M = 2";
}

// Where the normal force falls the strength falls, and the spring shortens by slip. The walls have hardly
// moved, and the joint dilates as little, whichever way they moved. It counted the shortening as motion of
// the walls, and contracted by its slope.
TEST(BartonBandis, SlipAgainstTheDisplacementLeavesTheDilation) {
    const BartonBandis law = barton_1985_granite();
    const double k = law.shear_stiffness(law.fresh(true), force, length);
    const auto there =
        law.advance(law.fresh(true), {granite_peak, 2 * granite_peak, force, length, false, 0, k});
    EXPECT_GT(there.locked_slope, 0.1);
    for (const double displacement : {1e-9, -1e-9}) {
        const auto shortened =
            law.advance(there, {granite_peak / 2, displacement, force / 2, length, false, 0, k});
        EXPECT_NEAR(shortened.dilation, there.dilation, 1e-9) << displacement;
    }
}

// At a corner the stress is so large that the strength is that of the residual angle. The dilation, of the
// stress at rest, is no steeper than that.
TEST(BartonBandis, DilatesNoSteeperThanItsStrengthClimbs) {
    const BartonBandis law = barton_1985_granite();
    const double weak = 5e2, k = law.shear_stiffness(law.fresh(true), weak, length);
    const auto there =
        law.advance(law.fresh(true), {granite_peak / 2, granite_peak, weak, length, false, 0, k});
    const double slip = granite_peak / 10, corner = 1e-6;
    const auto slid = law.advance(there, {slip, slip, weak, corner, false, 0, k});
    const double strength = law.strength(slid, weak, corner, {}).forward / weak;
    EXPECT_GT(there.locked_slope, 1.01 * strength) << "the stress at rest would give more";
    EXPECT_LE(slid.dilation - there.dilation, strength * slip * (1 + 1e-12));
    EXPECT_LE(slid.locked_slope, strength * (1 + 1e-12));
}

// The walls part beyond the distance at which they have worn, meet again on the way back, and wear nowhere.
TEST(BartonBandis, AnOpenJointFollowsItsWalls) {
    const BartonBandis law = barton_1985_granite();
    const auto there = after(law, 2 * granite_peak), further = after(law, 3 * granite_peak);
    const auto flown = law.fly(there, flight(granite_peak));
    EXPECT_EQ(flown.position, there.position + granite_peak);
    EXPECT_EQ(flown.furthest, there.furthest);
    EXPECT_NEAR(flown.dilation, further.dilation, 1e-9) << "as under a force, without an elastic part";
    EXPECT_GT(flown.dilation, there.dilation + 1e-5);
    EXPECT_NEAR(law.fly(flown, flight(-granite_peak)).dilation, there.dilation, 1e-12);
    EXPECT_EQ(law.strength(there, -1e5, length, {}).forward, 0);
}

TEST(BartonBandis, LandsOnThePlaceItFlewTo) {
    const BartonBandis law = barton_1985_granite();
    const auto flown = law.fly(after(law, 2 * granite_peak), flight(granite_peak));
    const double there = law.strength(after(law, 3 * granite_peak), 1e5, length, {}).forward;
    EXPECT_NEAR(law.strength(flown, 1e5, length, {}).forward, there, 1e-9 * there);
}

}  // namespace
}  // namespace rockslope::barton_bandis_test
