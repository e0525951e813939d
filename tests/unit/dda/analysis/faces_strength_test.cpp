// What is put together once in a step against the motion that faces_motion makes of each displacement.

#include "dda/analysis/faces_strength.hpp"

#include <gtest/gtest.h>

#include "dda/analysis/joint_motion.hpp"
#include "support/rough_faces.hpp"

namespace {

using dda::Pressed;

TEST(FacesStrength, IsThatOfTheFacesMotion) {
    scene::Dice dice(17);
    const scene::RoughFaces step(dice, {2, 2, 1, 3, 2, 1, 2, 4, 2, 2});
    const dda::StepProblem problem = step.problem();
    const dda::FacesStrength strengths(problem);
    ASSERT_EQ(strengths.count(), 10u);
    int bearing = 0;
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<Pressed> pressed;
        for (std::size_t k = 0; k < step.contacts.size(); ++k)
            pressed.push_back({dice.between(-2e5, 1e6), dice.between(-2e-3, 2e-3)});
        for (std::size_t pair = 0; pair < strengths.count(); ++pair) {
            const std::span<const int> members = step.faces.contacts_of(pair);
            for (const int k : members)
                EXPECT_EQ(strengths.pair_of(static_cast<std::size_t>(k)), static_cast<int>(pair));
            const dda::FacesPressed together =
                strengths.pressed(pair, [&](std::size_t contact) { return pressed[contact]; });
            const dda::Strength found =
                together.normal > 0 ? strengths.over_normal_force(pair, together) : dda::Strength{};
            const auto whole = dda::faces_motion(members, step.contacts, [&](int k) {
                const auto c = static_cast<std::size_t>(k);
                return dda::contact_motion(step.model, step.contacts[c], step.springs[c].shear_stiffness,
                                           pressed[c].normal, pressed[c].shearing, 0);
            });
            dda::Strength expected;
            if (whole) {
                const auto& first = step.contacts[static_cast<std::size_t>(members[0])];
                const dda::ContactMotion& m = whole->motion;
                expected =
                    dda::strength(step.model.joint_material_at(first.joint_material).law, *whole->history,
                                  m.normal_force, m.length, {m.displacement, m.shear_force, m.stiffness});
                const double share = 1 / step.model.strength_reduction / m.normal_force;
                expected = {expected.forward * share, expected.backward * share, 0};
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
