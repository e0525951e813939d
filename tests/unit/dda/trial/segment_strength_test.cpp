// SegmentStrength, which prepares its input once a step, against segment_motion at each displacement.

#include "dda/trial/segment_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/trial/joint_motion.hpp"
#include "support/resting_block.hpp"
#include "support/rough_segments.hpp"

namespace rockslope::segment_strength_test {
namespace {

using dda::ContactLoading;

TEST(SegmentStrength, MatchesTheSegmentMotion) {
    scene::RandomSource random(17);
    const scene::RoughSegments step(random, {2, 2, 1, 3, 2, 1, 2, 4, 2, 2});
    const dda::StepProblem problem = step.problem();
    const dda::SegmentStrength strengths(problem);
    ASSERT_EQ(strengths.count(), 10u);
    int bearing = 0;
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<ContactLoading> loading;
        for (std::size_t k = 0; k < step.contacts.size(); ++k)
            loading.push_back({random.between(-2e5, 1e6), random.between(-2e-3, 2e-3)});
        for (std::size_t segment = 0; segment < strengths.count(); ++segment) {
            const std::span<const dda::ContactIndex> members = step.segments.contacts_of(segment);
            for (const dda::ContactIndex k : members)
                EXPECT_EQ(strengths.segment_of(k), static_cast<int>(segment));
            const dda::SegmentLoading combined =
                strengths.loading(segment, [&](std::size_t contact) { return loading[contact]; });
            const dda::Strength found =
                combined.normal > 0 ? strengths.over_normal_force(segment, combined) : dda::Strength{};
            const dda::SegmentMotion combined_motion =
                dda::segment_motion(members, step.contacts, [&](dda::ContactIndex k) {
                    const auto c = static_cast<std::size_t>(k);
                    return dda::contact_motion(step.model, step.contacts[c], step.springs[c].shear_stiffness,
                                               loading[c].normal, loading[c].shearing, 0);
                });
            dda::Strength expected;
            if (combined_motion.motion.normal_force > 0) {
                const auto& first = step.contacts[members[0]];
                const dda::ContactMotion& m = combined_motion.motion;
                expected = dda::strength(step.model.joint_material_at(first.joint_material).law,
                                         *combined_motion.history, m.normal_force, m.length,
                                         {m.displacement, m.shear_force, m.stiffness});
                const double factor = 1 / step.model.strength_reduction / m.normal_force;
                expected = {expected.forward * factor, expected.backward * factor, 0};
                ++bearing;
            }
            EXPECT_EQ(found.forward, expected.forward);
            EXPECT_EQ(found.backward, expected.backward);
            EXPECT_EQ(found.tensile, expected.tensile);
        }
    }
    EXPECT_GT(bearing, 400);
}

// d tau/ds = k (1 - tau/tau_m)/(1 - r) of Eq. (73), here without damage and with r = 0. The secant is over a
// hundredth of tau/k, so it is smaller by half a percent at most.
TEST(SegmentStrength, HardensByTheSlopeOfItsLaw) {
    const double bound = std::tan(scene::radians(30)), normal = 2e5;
    scene::RestingContacts block(dda::ContinuouslyYielding{scene::radians(30), scene::radians(30), 1e-3});
    const dda::SegmentStrength strengths(block.problem);
    ASSERT_EQ(strengths.count(), 1u);
    ASSERT_EQ(strengths.stiffness(0), 2e9);
    for (const int direction : {1, -1}) {
        for (const double way : {2e-6, 5e-5, 2e-4}) {
            const dda::SegmentLoading loading{normal, direction * way};
            const dda::Strength strength = strengths.over_normal_force(0, loading);
            const double here = direction > 0 ? strength.forward : strength.backward;
            const dda::Hardening found = strengths.hardening(0, loading, strength);
            const double expected = 2e9 / normal * (1 - here / bound);
            EXPECT_NEAR(direction > 0 ? found.forward : found.backward, expected, 0.01 * expected) << way;
            EXPECT_EQ(direction > 0 ? found.backward : found.forward, 0) << "against the displacement";
        }
    }
    EXPECT_FALSE(strengths.hardening(0, {normal, 0}, strengths.over_normal_force(0, {normal, 0})).any());
}

// A joint that wears softens behind its peak: no hardening is negative.
TEST(SegmentStrength, HasNoHardeningWhereItSoftens) {
    scene::RestingContacts block(dda::ContinuouslyYielding{scene::radians(40), scene::radians(20), 1e-4});
    const dda::SegmentStrength strengths(block.problem);
    const dda::SegmentLoading loading{2e5, 3e-4};
    const dda::Strength strength = strengths.over_normal_force(0, loading);
    ASSERT_LT(strengths.over_normal_force(0, {2e5, 4e-4}).forward, strength.forward);
    EXPECT_FALSE(strengths.hardening(0, loading, strength).any());
}

}  // namespace
}  // namespace rockslope::segment_strength_test
