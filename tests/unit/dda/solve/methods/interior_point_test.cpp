#include "dda/solve/methods/interior_point.hpp"

#include <gtest/gtest.h>

#include "dda/solve/contact_solution.hpp"
#include "support/wall_from_inside.hpp"

namespace rockslope::interior_point_test {
namespace {

using namespace scene;

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
        EXPECT_LE(result.iterations, 30) << "22 to 27 with friction, when this was written";
        at.trials.set_displacement(at.d, at.d);
        at.interior.set_linear_forces();
        at.contacts.bounds.update_all();
        from.force_change = at.trials.force_change().largest;
    }
    ASSERT_GT(at.trials.tolerance(), 0);
    EXPECT_LE(*from.force_change, at.trials.tolerance());
}

// Without friction the potential is convex and the solution unique: both methods must find it. Each method's
// blocks are out of balance by less than the tolerance, and their inertia of 1e8 N/m holds them.
TEST_P(InteriorPointOfWalls, FindsTheMinimumThatTheActiveSetFinds) {
    WallFromInside at(GetParam(), 0);
    const dda::InteriorPointResult found = at.interior.solve(at.d, {});
    ASSERT_TRUE(found.converged);
    EXPECT_LE(found.iterations, 25);
    at.trials.set_displacement(at.d, at.d);
    at.contacts.bounds.update_all();
    at.trials.force_change();
    const LoadedWall& wall = at.wall;
    const dda::OpenCloseResult other =
        dda::solve_contacts(at.problem, wall.step.pattern, *wall.solver, at.wall.work, wall.step.pool);
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
