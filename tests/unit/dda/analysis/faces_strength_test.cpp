// What is put together once in a step against the motion that faces_motion makes of each displacement.

#include "dda/analysis/faces_strength.hpp"

#include <gtest/gtest.h>

#include "dda/analysis/joint_motion.hpp"
#include "support/cyclic_joints.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace {

using namespace scene;
using dda::Contact;
using dda::ContactState;
using dda::Pressed;

/// Contacts of one pair of faces after the other, at a step's start.
struct Faces {
    dda::Model model;
    std::vector<Contact> contacts;
    dda::JointFaces faces;
    std::vector<dda::ContactSprings> springs;
    dda::RowContacts row_contacts;
    dda::StepControl control;
    dda::BlockSystem blocks;
    dda::BaseSystem base;
    dda::RowMap rows{model.motion};

    /// @param ends contacts of each pair, in turn.
    Faces(Dice& dice, const std::vector<int>& ends) {
        model.joint_materials.push_back({"granite", joint_tests::granite(), 0, 0});
        model.joint_materials.push_back({"plane", joint_tests::sliding_plane(), 0, 0});
        model.strength_reduction = 1.25;
        for (std::size_t pair = 0; pair < ends.size(); ++pair) {
            for (int k = 0; k < ends[pair]; ++k) add(dice, static_cast<int>(pair), k);
        }
        faces = dda::JointFaces(model, contacts);
    }
    dda::StepProblem problem() const {
        return {model, control, rows,    base,         blocks, {}, contacts,
                faces, {},      springs, row_contacts, {},     {}, 1};
    }

  private:
    void add(Dice& dice, int pair, int k) {
        Contact contact;
        contact.joint_material = pair % 2;
        contact.corner_block = pair + 1;
        contact.length = dice.between(0.1, 1);
        contact.point = {static_cast<double>(k), 0};
        contact.normal = {0, 1};
        contact.state = static_cast<ContactState>(dice.one_of(3));
        if (contact.state != ContactState::open) contact.normal_force = dice.between(1e4, 1e6);
        contact.shear_force = contact.normal_force * dice.between(-0.5, 0.5);
        const dda::JointLaw& law = model.joint_material_at(contact.joint_material).law;
        contact.history = dda::advance(
            law, dda::fresh_history(law, true),
            {0, dice.between(-5e-3, 5e-3), 1e5, contact.length, false, 0, dice.between(1e8, 1e9)});
        contacts.push_back(contact);
        springs.emplace_back().shear_stiffness = dice.between(1e8, 1e9);
    }
};

TEST(FacesStrength, IsThatOfTheFacesMotion) {
    Dice dice(17);
    const Faces step(dice, {2, 2, 1, 3, 2, 1, 2, 4, 2, 2});
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
