#include "dda/analysis/interior_point.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "dda/analysis/open_close_iteration.hpp"
#include "support/first_step.hpp"

using namespace rockslope;

namespace {

using namespace scene;

/// The first step of a wall with inertia and random loads that press it together: contacts open, close and
/// slide.
struct LoadedWall {
    FirstStep step;
    dda::BlockMatrix work;
    std::unique_ptr<dda::LinearSolver> solver;
    std::vector<Vec6> start;

    LoadedWall(unsigned seed, double friction_angle)
        : solver(dda::make_linear_solver(dda::SolverKind::multifrontal, step.pool)) {
        for (dda::JointMaterial& material : step.model.joint_materials) {
            dda::MohrCoulomb law;
            law.friction_angle = friction_angle;
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
    dda::TrialContacts trials(const dda::StepProblem& problem) const {
        dda::TrialContacts trials(problem, step.pool);
        trials.set_displacement(start, start);
        trials.select_first_entrances();
        trials.update_bounds();
        return trials;
    }
};

class InteriorPointOfWalls : public testing::TestWithParam<unsigned> {};

// The solution obeys the laws as the open-close iteration's does: contact forces that balance the blocks
// differ from those of the laws by less than the tolerance.
TEST_P(InteriorPointOfWalls, ObeysTheLaws) {
    LoadedWall wall(GetParam(), .6);
    const dda::StepProblem problem = wall.step.problem();
    dda::TrialContacts trials = wall.trials(problem);
    dda::StepMatrix matrix(problem, wall.step.pattern, wall.work, wall.step.pool);
    dda::InteriorPoint interior(problem, trials, matrix, *wall.solver, wall.step.pool);
    dda::PerRow<Vec6> d = wall.start;
    dda::PathStart from;
    // Each round linearises the gaps at the last one's end; the loads move the blocks by 0.1 mm.
    for (int round = 0; round < 3; ++round) {
        const dda::InteriorPointResult result = interior.solve(d, from);
        ASSERT_TRUE(result.converged);
        EXPECT_LE(result.iterations, 25);
        trials.set_displacement(d, d);
        interior.set_linear_forces();
        trials.update_all_bounds();
        from.force_change = trials.force_change().largest;
    }
    ASSERT_GT(trials.tolerance(), 0);
    EXPECT_LE(from.force_change, trials.tolerance());
}

// Without friction the potential is convex and the solution unique: both methods must find it. Forces agree
// to the tolerance, displacements therefore to some times the tolerance over the inertia.
TEST_P(InteriorPointOfWalls, FindsTheMinimumThatTheActiveSetFinds) {
    LoadedWall wall(GetParam(), 0);
    const dda::StepProblem problem = wall.step.problem();
    dda::TrialContacts trials = wall.trials(problem);
    dda::StepMatrix matrix(problem, wall.step.pattern, wall.work, wall.step.pool);
    dda::InteriorPoint interior(problem, trials, matrix, *wall.solver, wall.step.pool);
    dda::PerRow<Vec6> d = wall.start;
    ASSERT_TRUE(interior.solve(d, {}).converged);
    trials.set_displacement(d, d);
    trials.update_all_bounds();
    trials.force_change();
    const dda::OpenCloseResult other =
        dda::iterate_open_close(problem, wall.step.pattern, *wall.solver, wall.work, wall.step.pool);
    ASSERT_TRUE(other.converged);
    double largest = 0;
    for (const dda::RowIndex row : d.indices())
        largest = std::max(largest, (d[row] - other.displacement[row]).head<2>().norm());
    EXPECT_LE(largest, 100 * trials.tolerance() / 1e8);
}

// With held bounds the problem is convex, whatever the friction.
TEST_P(InteriorPointOfWalls, SolvesTheProblemWithHeldBounds) {
    LoadedWall wall(GetParam(), 1.2);
    const dda::StepProblem problem = wall.step.problem();
    dda::TrialContacts trials = wall.trials(problem);
    dda::StepMatrix matrix(problem, wall.step.pattern, wall.work, wall.step.pool);
    dda::InteriorPoint interior(problem, trials, matrix, *wall.solver, wall.step.pool);
    dda::PerRow<Vec6> d = wall.start;
    EXPECT_TRUE(interior.solve(d, {.hold_bounds = true}).converged);
}

INSTANTIATE_TEST_SUITE_P(Seeds, InteriorPointOfWalls, testing::Range(1U, 9U));

}  // namespace
