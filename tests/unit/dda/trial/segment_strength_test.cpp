// SegmentStrength, which prepares its input once a step, against segment_motion at each displacement.

#include "dda/trial/segment_strength.hpp"

#include <gtest/gtest.h>

#include "dda/trial/joint_motion.hpp"
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

}  // namespace
}  // namespace rockslope::segment_strength_test
