#pragma once

#include "dda/analysis/shear_sharing.hpp"
#include "dda/trial/step_problem.hpp"
#include "support/random_shapes.hpp"
#include "support/step_system.hpp"  // IWYU pragma: export
#include "support/walls.hpp"

namespace rockslope::scene {

/// The input of the open-close iteration in the first step of a model: by default of a wall. Blocks have no
/// inertia, and a unit stiffness in each of their unknowns.
struct FirstStep {
    ThreadPool pool{1};
    dda::Model model;
    dda::RowMap rows{model.motion};
    dda::State state = dda::initial_state(model);
    std::vector<Vec6> still = std::vector<Vec6>(state.blocks.velocity.size(), Vec6::Zero());
    dda::MidStep mid = dda::predict_mid_step(model, state.blocks, still, pool);
    dda::FoundContacts found = find();
    const dda::ContactSet& set = found.set;
    std::vector<dda::ContactSprings> springs =
        dda::contact_springs(model, rows, mid, still, set.contacts, pool);
    std::vector<const dda::EvaluatedContact*> guess =
        std::vector<const dda::EvaluatedContact*>(set.contacts.size(), nullptr);
    std::vector<dda::BoltSpring> bolts = dda::bolt_springs(model, rows, mid, still);
    dda::BaseSystem base;
    dda::StepControl control;
    dda::BlockPattern pattern;

    dda::RowContacts row_contacts;

    FirstStep() : FirstStep(Scene::mohr_coulomb(35)) {}
    /// @param law of the joints of the wall.
    explicit FirstStep(const dda::JointLaw& law) : FirstStep(wall_of(law)) {}
    explicit FirstStep(dda::Model other) : model(std::move(other)) {
        row_contacts.find(rows.count(), springs);
        std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
        for (const auto& s : springs) {
            if (s.rows.first >= 0 && s.rows.second >= 0) pairs.emplace_back(s.rows.first, s.rows.second);
        }
        for (const auto& bolt : bolts)
            if (bolt.rows.first >= 0 && bolt.rows.second >= 0)
                pairs.emplace_back(bolt.rows.first, bolt.rows.second);
        pattern = dda::BlockPattern::from_pairs(rows.count(), std::move(pairs));
        base.stiffness.assign(rows.count(), dda::Mat6::Identity());
        base.load.assign(rows.count(), Vec6::Zero());
    }
    dda::StepProblem problem() const {
        return {model,
                control,
                rows,
                base,
                state.blocks,
                still,
                set.contacts,
                found.segments,
                guess,
                springs,
                row_contacts,
                bolts,
                state.bolt_force,
                dda::StepTime(1)};
    }

  private:
    static dda::Model wall_of(const dda::JointLaw& law) {
        dda::Model wall = running_bond_wall(8, 8, 10).model;
        wall.joint_materials[0].law = law;
        return wall;
    }
    dda::FoundContacts find() const {
        dda::FoundContacts contacts =
            dda::find_contacts(model, state.contacts,
                               {state.blocks.vertices, mid.vertices, {}, 1e-3, 1, 1e-9, 0.005, true}, pool);
        dda::share_shear_force(model, contacts.segments, contacts.set.contacts);
        return contacts;
    }
};

/// Displacements of 0.1 mm in random directions for one row in `one_in`, at random: contacts open and slip.
inline std::vector<Vec6> moved(RandomSource& random, int rows, unsigned one_in) {
    std::vector<Vec6> d(static_cast<std::size_t>(rows), Vec6::Zero());
    for (Vec6& of_row : d) {
        if (random.index_below(one_in) == 0) of_row.head<2>() = 1e-4 * random.direction();
    }
    return d;
}

}  // namespace rockslope::scene
