#pragma once

#include <memory>
#include <vector>

#include "dda/solve/methods/interior_point.hpp"
#include "support/first_step.hpp"

namespace rockslope::scene {

/// The first step of a wall with inertia and random loads that press it together: contacts open, close and
/// slide.
struct LoadedWall {
    FirstStep step;
    dda::IterationWorkspace work;
    std::unique_ptr<dda::LinearSolver> solver;
    std::vector<Vec6> start;

    LoadedWall(unsigned seed, double friction_angle)
        : solver(dda::make_linear_solver(dda::SolverKind::multifrontal, step.pool)) {
        for (dda::JointMaterial& material : step.model.joint_materials) {
            dda::MohrCoulomb law;
            law.friction_angle = law.residual_friction_angle = friction_angle;
            material.law = law;
        }
        RandomSource random(seed);
        Vec2 centre = Vec2::Zero();
        for (const dda::AreaMoments& m : step.state.blocks.moments) centre += m.centroid;
        centre /= static_cast<double>(step.state.blocks.moments.size());
        for (const dda::RowIndex row : step.base.load.indices()) {
            const Vec2 inwards = centre - step.state.blocks.moments[step.rows.block_of[row]].centroid;
            step.base.load[row].head<2>() = 1e4 * random.direction() + 3e4 * inwards.normalized();
        }
        for (dda::Mat6& stiffness : step.base.stiffness) stiffness = 1e8 * dda::Mat6::Identity();
        start = moved(random, step.rows.count(), 1);
        solver->analyze(step.pattern);
    }
};

/// The interior-point method at the start of that step.
struct WallFromInside {
    LoadedWall wall;
    dda::StepProblem problem = wall.step.problem();
    dda::StepContacts contacts{problem, wall.step.pool};
    dda::TrialContacts& trials = contacts.trials;
    dda::StepMatrix matrix{problem, wall.step.pattern, wall.work.matrix, wall.step.pool};
    dda::InteriorPoint interior{problem, contacts, matrix, *wall.solver, wall.step.pool};
    dda::PerRow<Vec6> d{wall.start};

    WallFromInside(unsigned seed, double friction_angle) : wall(seed, friction_angle) {
        trials.set_displacement(wall.start, wall.start);
        contacts.entrances.select_first();
        contacts.bounds.update();
    }
};

}  // namespace rockslope::scene
