#include "dda/analysis/interior_point.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "dda/analysis/open_close_iteration.hpp"
#include "support/first_step.hpp"

namespace rockslope::interior_point_test {
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

/// The interior-point method at the start of that step.
struct WallFromInside {
    LoadedWall wall;
    dda::StepProblem problem = wall.step.problem();
    dda::TrialContacts trials = wall.trials(problem);
    dda::StepMatrix matrix{problem, wall.step.pattern, wall.work, wall.step.pool};
    dda::InteriorPoint interior{problem, trials, matrix, *wall.solver, wall.step.pool};
    dda::PerRow<Vec6> d{wall.start};

    WallFromInside(unsigned seed, double friction_angle) : wall(seed, friction_angle) {}
};

class InteriorPointOfWalls : public testing::TestWithParam<unsigned> {};

// The solution obeys the laws as the open-close iteration's does: contact forces that balance the blocks
// differ from those of the laws by less than the tolerance.
TEST_P(InteriorPointOfWalls, ObeysTheLaws) {
    WallFromInside at(GetParam(), .6);
    dda::PathStart from;
    // Each round linearises the gaps at the last one's end; the loads move the blocks by 0.1 mm.
    for (int round = 0; round < 3; ++round) {
        const dda::InteriorPointResult result = at.interior.solve(at.d, from);
        ASSERT_TRUE(result.converged);
        EXPECT_LE(result.iterations, 25);
        at.trials.set_displacement(at.d, at.d);
        at.interior.set_linear_forces();
        at.trials.update_all_bounds();
        from.force_change = at.trials.force_change().largest;
    }
    ASSERT_GT(at.trials.tolerance(), 0);
    EXPECT_LE(*from.force_change, at.trials.tolerance());
}

// Without friction the potential is convex and the solution unique: both methods must find it. Each method's
// blocks are out of balance by less than the tolerance, and their inertia of 1e8 N/m holds them.
TEST_P(InteriorPointOfWalls, FindsTheMinimumThatTheActiveSetFinds) {
    WallFromInside at(GetParam(), 0);
    ASSERT_TRUE(at.interior.solve(at.d, {}).converged);
    at.trials.set_displacement(at.d, at.d);
    at.trials.update_all_bounds();
    at.trials.force_change();
    const LoadedWall& wall = at.wall;
    const dda::OpenCloseResult other =
        dda::iterate_open_close(at.problem, wall.step.pattern, *wall.solver, at.wall.work, wall.step.pool);
    ASSERT_TRUE(other.converged);
    double largest = 0;
    for (const dda::RowIndex row : at.d.indices())
        largest = std::max(largest, (at.d[row] - other.displacement[row]).head<2>().norm());
    EXPECT_LE(largest, at.trials.tolerance() / 1e8) << "0.15 times when this was written";
}

// With held bounds the problem is convex, whatever the friction.
TEST_P(InteriorPointOfWalls, SolvesTheProblemWithHeldBounds) {
    WallFromInside at(GetParam(), 1.2);
    EXPECT_TRUE(at.interior.solve(at.d, {.hold_bounds = true}).converged);
}

INSTANTIATE_TEST_SUITE_P(Seeds, InteriorPointOfWalls, testing::Range(1U, 9U));

}  // namespace
}  // namespace rockslope::interior_point_test
