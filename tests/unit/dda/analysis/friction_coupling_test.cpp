#include "dda/analysis/friction_coupling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "dda/analysis/step_matrix.hpp"
#include "support/first_step.hpp"

using namespace rockslope;

namespace {

using namespace scene;

/// The first step of a wall whose blocks have been moved at random, so that many contacts slide.
struct SlidingWall {
    FirstStep step;
    dda::StepProblem problem = step.problem();
    dda::TrialContacts trials{problem, step.pool};
    dda::BlockMatrix work;
    std::unique_ptr<dda::LinearSolver> solver;

    SlidingWall(unsigned seed, dda::SolverKind kind) : solver(dda::make_linear_solver(kind, step.pool)) {
        RandomSource random(seed);
        const std::vector<Vec6> displacement = moved(random, step.rows.count(), 1);
        trials.set_displacement(displacement, displacement);
        trials.select_first_entrances();
        trials.update_bounds();
        trials.update_active_set();
        trials.force_change();  // sets the largest force, which scales the tolerance
        dda::StepMatrix matrix(problem, step.pattern, work, step.pool);
        matrix.assemble(trials);
        solver->analyze(step.pattern);
        EXPECT_TRUE(solver->factorize(matrix.matrix()));
    }
    std::vector<Vec6> load() const {
        std::vector<Vec6> load = step.base.load;
        for (std::size_t k = 0; k < trials.count(); ++k) {
            const dda::ContactSprings& s = step.springs[k];
            const dda::Forces forces = trials.linear_forces(k, s.normal.prescribed, s.shear.prescribed);
            s.rows.add_force(s.normal, forces.normal, load);
            s.rows.add_force(s.shear, -forces.shear, load);
        }
        return load;
    }
    std::vector<Vec6> solution() const {
        std::vector<Vec6> d = load();
        solver->solve(d);
        return d;
    }
    /// The largest difference between friction forces and the bounds of the laws at the normal forces of d.
    double bound_violation(const std::vector<Vec6>& d) const {
        double largest = 0;
        for (std::size_t k = 0; k < trials.count(); ++k) {
            if (!trials.has_normal_spring(k) || trials.has_shear_spring(k)) continue;
            const dda::ContactSprings& s = step.springs[k];
            const double normal = trials.linear_normal(k, s.rows.measure(s.normal, d));
            const dda::Contact& contact = step.set.contacts[k];
            const double bound =
                normal > 0 || trials.is_bonded(k)
                    ? strength(trials.law_of(k), contact.history, normal, contact.length).forward
                    : 0;
            const double sign = trials.slides_forward(k) ? 1 : -1;
            largest = std::max(largest, std::abs(sign * bound - trials.friction_force(k)));
        }
        return largest;
    }
};

class FrictionCouplingOfMovedWalls : public testing::TestWithParam<std::tuple<unsigned, dda::SolverKind>> {};

// The result combines several solutions. It must solve the linear system with the final friction forces, up
// to rounding that refinement removes, and these forces must be closer to the bounds than before.
TEST_P(FrictionCouplingOfMovedWalls, MatchesTheBoundsAndSolvesTheSystem) {
    const auto [seed, kind] = GetParam();
    SlidingWall wall(seed, kind);
    std::vector<Vec6> d = wall.solution();
    const double before = wall.bound_violation(d);
    ASSERT_GT(before, wall.trials.tolerance()) << "the friction forces are at their bounds already";
    dda::FrictionCoupling coupling(wall.problem, wall.trials, *wall.solver, wall.step.pool);
    const int substitutions = coupling.solve(d);
    EXPECT_GT(substitutions, 0);
    EXPECT_LE(substitutions, 12);
    wall.solver->refine(d, wall.load(), dda::full_tolerance);
    EXPECT_LE(wall.bound_violation(d), 0.05 * before);
    const std::vector<Vec6> solution = wall.solution();
    double size = 0;
    for (const Vec6& of_row : solution) size = std::max(size, of_row.cwiseAbs().maxCoeff());
    for (std::size_t r = 0; r < d.size(); ++r)
        EXPECT_LT((d[r] - solution[r]).cwiseAbs().maxCoeff(), 1e-10 * size) << "row " << r;

    // A second solution changes nothing if the first one has converged.
    const std::vector<Vec6> solved = d;
    wall.trials.force_change();
    if (wall.bound_violation(d) <= wall.trials.tolerance() / 2) {
        EXPECT_EQ(coupling.solve(d), 0);
        EXPECT_EQ(d, solved);
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, FrictionCouplingOfMovedWalls,
                         testing::Combine(testing::Values(1u, 2u, 3u, 4u, 5u),
                                          testing::Values(dda::SolverKind::multifrontal,
                                                          dda::SolverKind::refined)));

}  // namespace
