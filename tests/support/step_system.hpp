#pragma once

#include "dda/contact/find_contacts.hpp"
#include "dda/linear/block_matrix.hpp"
#include "dda/terms/springs.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// The linear system of a scene's first step.
struct StepSystem {
    dda::BlockPattern pattern;
    dda::BlockMatrix matrix;
    std::vector<Vec6> load;
};

/// Adds stiffness * (measure)^2 / 2 to the system.
inline void add_stiffness(const dda::BlockPair& rows, const dda::RelativeMeasure& relative, double stiffness,
                          const dda::BlockPattern& pattern, dda::BlockMatrix& matrix) {
    if (rows.first >= 0) matrix.add_rank_one(rows.first, rows.gradient_first(relative), stiffness);
    if (rows.second >= 0) matrix.add_rank_one(rows.second, rows.gradient_second(relative), stiffness);
    if (rows.first >= 0 && rows.second >= 0)
        matrix.add_outer(pattern, rows.first, rows.second, stiffness * rows.gradient_first(relative),
                         rows.gradient_second(relative));
}

/// The linear system of a first step of `dt`, s, with all contacts locked except those for which open(index)
/// is true.
inline StepSystem step_system(
    const dda::Model& model, double dt,
    const std::function<bool(std::size_t)>& open = [](std::size_t) { return false; }) {
    const ThreadPool pool(1);
    const dda::RowMap rows(model.motion);
    const dda::State state = dda::initial_state(model);
    const std::vector<Vec6> still(state.blocks.velocity.size(), Vec6::Zero());
    const dda::MidStep mid = dda::predict_mid_step(model, state.blocks, still, ThreadPool(1));
    const dda::ContactSet contacts =
        dda::find_contacts(model, state.contacts,
                           {state.blocks.vertices, mid.vertices, {}, 1e-3, 1, 1e-9, dt, true}, pool)
            .set;
    const auto springs = dda::contact_springs(model, rows, mid, still, contacts.contacts, pool);

    StepSystem system;
    std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
    for (const auto& s : springs) {
        if (s.rows.first >= 0 && s.rows.second >= 0) pairs.emplace_back(s.rows.first, s.rows.second);
    }
    system.pattern = dda::BlockPattern::from_pairs(rows.count(), std::move(pairs));
    dda::BaseSystem base;
    base.stiffness.assign(rows.count(), dda::Mat6::Zero());
    base.load.assign(rows.count(), Vec6::Zero());
    dda::add_inertia(rows, state.blocks, {0.5, 1, dt}, 0, base);
    dda::add_elasticity(model, rows, state.blocks, dt, base);
    dda::add_fixed_points(model, rows, state.blocks, mid, base);
    for (std::size_t r = 0; r < base.load.size(); ++r) {
        const dda::BlockIndex b = rows.block_of[r];
        base.load[r].head<2>() += state.blocks.mass[b] * model.gravity;
    }
    system.matrix.reset(system.pattern);
    system.matrix.diagonal = base.stiffness;
    system.load = base.load;
    for (std::size_t k = 0; k < springs.size(); ++k) {
        if (open(k)) continue;
        const dda::ContactSprings& s = springs[k];
        add_stiffness(s.rows, s.normal, s.normal_stiffness, system.pattern, system.matrix);
        add_stiffness(s.rows, s.shear, s.shear_stiffness, system.pattern, system.matrix);
    }
    return system;
}

}  // namespace rockslope::scene
