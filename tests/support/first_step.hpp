#pragma once

#include "dda/analysis/step_problem.hpp"
#include "support/random_shapes.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"

namespace rockslope::scene {

/// The input of the open-close iteration in the first step of a wall.
struct FirstStep {
    ThreadPool pool{1};
    dda::Model model = running_bond_wall(8, 8, 10).model;
    dda::RowMap rows{model.motion};
    dda::State state = dda::initial_state(model);
    std::vector<Vec6> still = std::vector<Vec6>(state.blocks.velocity.size(), Vec6::Zero());
    dda::MidStep mid = dda::predict_mid_step(model, state.blocks, still, pool);
    dda::FoundContacts found = dda::find_contacts(
        model, state.contacts, {state.blocks.vertices, mid.vertices, {}, 1e-3, 1, 1e-9, 0.005, true}, pool);
    const dda::ContactSet& set = found.set;
    std::vector<dda::ContactSprings> springs =
        dda::contact_springs(model, rows, mid, still, set.contacts, pool);
    std::vector<const dda::EvaluatedContact*> guess =
        std::vector<const dda::EvaluatedContact*>(set.contacts.size(), nullptr);
    dda::BaseSystem base;
    dda::StepControl control;
    dda::BlockPattern pattern;

    dda::RowContacts row_contacts;

    FirstStep() {
        row_contacts.find(rows.count(), springs);
        std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
        for (const auto& s : springs) {
            if (s.rows.first >= 0 && s.rows.second >= 0) pairs.emplace_back(s.rows.first, s.rows.second);
        }
        pattern = dda::BlockPattern::from_pairs(rows.count(), std::move(pairs));
        base.stiffness.assign(rows.count(), dda::Mat6::Identity());
        base.load.assign(rows.count(), Vec6::Zero());
    }
    dda::StepProblem problem() const {
        return {model,          control, rows,    base,         state.blocks, still, set.contacts,
                found.segments, guess,   springs, row_contacts, {},           {},    1};
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
