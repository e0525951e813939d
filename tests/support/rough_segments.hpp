#pragma once

#include <vector>

#include "dda/trial/step_problem.hpp"
#include "support/cyclic_joints.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"  // IWYU pragma: export

namespace rockslope::scene {

/// Contacts of a sequence of rough joint segments at the start of a step, with random states and histories.
struct RoughSegments {
    dda::Model model;
    std::vector<dda::Contact> contacts;
    dda::JointSegments segments;
    std::vector<dda::ContactSprings> springs;
    dda::RowContacts row_contacts;
    dda::StepControl control;
    dda::BlockSystem blocks;
    dda::BaseSystem base;
    dda::RowMap rows{model.motion};

    /// @param ends number of contacts of each segment.
    RoughSegments(RandomSource& random, const std::vector<int>& ends) {
        model.joint_materials.push_back({"granite", joint_tests::granite(), 0, 0});
        model.joint_materials.push_back({"plane", joint_tests::sliding_plane(), 0, 0});
        model.strength_reduction = 1.25;
        for (std::size_t pair = 0; pair < ends.size(); ++pair) {
            for (int k = 0; k < ends[pair]; ++k) add(random, static_cast<int>(pair), k);
        }
        segments = dda::JointSegments(model, contacts);
    }
    dda::StepProblem problem() const {
        return {model,    control, rows,    base,         blocks, {}, contacts,
                segments, {},      springs, row_contacts, {},     {}, dda::StepTime(1)};
    }

  private:
    void add(RandomSource& random, int pair, int k) {
        dda::Contact contact;
        contact.joint_material = pair % 2;
        contact.corner_block = pair + 1;
        contact.length = random.between(0.1, 1);
        contact.point = {static_cast<double>(k), 0};
        contact.normal = {0, 1};
        contact.state = static_cast<dda::ContactState>(random.index_below(3));
        if (contact.state != dda::ContactState::open) contact.normal_force = random.between(1e4, 1e6);
        contact.shear_force = contact.normal_force * random.between(-0.5, 0.5);
        const dda::JointLaw& law = model.joint_material_at(contact.joint_material).law;
        contact.history = dda::advance(
            law, dda::fresh_history(law, true),
            {0, random.between(-5e-3, 5e-3), 1e5, contact.length, false, 0, random.between(1e8, 1e9)});
        contacts.push_back(contact);
        springs.emplace_back().shear_stiffness = random.between(1e8, 1e9);
    }
};

}  // namespace rockslope::scene
