#include "dda/solve/methods/friction_coupling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "dda/solve/step_matrix.hpp"
#include "support/resting_block.hpp"

namespace rockslope::friction_coupling_test {
namespace {

using namespace scene;

/// The first step of a wall whose blocks have been moved at random, so that many contacts slide.
struct SlidingWall {
    FirstStep step;
    dda::StepProblem problem = step.problem();
    dda::StepContacts contacts{problem, step.pool};
    dda::TrialContacts& trials = contacts.trials;
    dda::BlockMatrix work;
    std::unique_ptr<dda::LinearSolver> solver;

    SlidingWall(const dda::JointLaw& law, unsigned seed, dda::SolverKind kind)
        : step(law), solver(dda::make_linear_solver(kind, step.pool)) {
        if (law.index() != dda::JointLaw(dda::MohrCoulomb()).index()) add_inertia();
        RandomSource random(seed);
        move(moved(random, step.rows.count(), 1));
    }
    /// Another model, moved by a displacement.
    SlidingWall(const dda::Model& model, const std::vector<Vec6>& displacement)
        : step(model), solver(dda::make_linear_solver(dda::SolverKind::multifrontal, step.pool)) {
        add_inertia();
        move(displacement);
    }
    void move(const std::vector<Vec6>& displacement) {
        trials.set_displacement(displacement, displacement);
        contacts.entrances.select_first();
        contacts.dilation.update();
        contacts.bounds.update();
        trials.update_active_set();
        trials.force_change();  // sets the largest force, which scales the tolerance
        dda::StepMatrix matrix(problem, step.pattern, work, step.pool);
        matrix.assemble(trials);
        solver->analyze(step.pattern);
        EXPECT_TRUE(solver->factorize(matrix.matrix()));
    }
    /// Asperities lift blocks off all others, which only their inertia then holds.
    void add_inertia() {
        constexpr double dt = 0.005;
        for (dda::Mat6& stiffness : step.base.stiffness) stiffness.setZero();
        dda::add_inertia(step.rows, step.state.blocks, {0.5, 1, dt}, 0, step.base);
        dda::add_elasticity(step.model, step.rows, step.state.blocks, dt, step.base);
    }
    std::vector<Vec6> load() const {
        std::vector<Vec6> load = step.base.load;
        for (std::size_t k = 0; k < trials.count(); ++k) {
            const dda::ContactSprings& s = step.springs[k];
            const dda::RelativeMeasure normal = trials.normal_measure(k);
            const dda::Forces forces = trials.linear_forces(k, normal.prescribed, s.shear.prescribed);
            s.rows.add_force(normal, forces.normal, load);
            s.rows.add_force(s.shear, -forces.shear, load);
        }
        return load;
    }
    std::vector<Vec6> solution() const {
        std::vector<Vec6> d = load();
        solver->solve(d);
        return d;
    }
    bool slides(dda::ContactIndex k) const {
        return trials[k].has_normal_spring && !trials[k].has_shear_spring;
    }
    double normal_force(dda::ContactIndex k, const std::vector<Vec6>& d) const {
        return trials[k].linear_normal(step.springs[k].rows.measure(trials.normal_measure(k), d));
    }
    /// The largest difference between friction forces and the bounds of the laws at the normal forces of d.
    /// The shear force of a tilted contact is its friction force and the tilt times its normal force.
    double bound_violation(const std::vector<Vec6>& d) const {
        double largest = 0;
        for (std::size_t k = 0; k < trials.count(); ++k) {
            if (!slides(k)) continue;
            const double normal = normal_force(k, d);
            const double shear = trials[k].friction_force + trials[k].tilt * std::max(normal, 0.0) +
                                 trials[k].sliding_stiffness * trials[k].held_shearing;
            const double sign = trials[k].slides_forward ? 1 : -1;
            largest = std::max(largest, std::abs(sign * bound(k, normal, d) - shear));
        }
        return largest;
    }
    /// The largest difference between the force that normal springs exert by a dilation and the one that the
    /// slope of the dilation, Eq. (85), gives at their normal forces.
    double dilation_violation(const std::vector<Vec6>& d) const {
        double largest = 0;
        for (const auto& dilation : contacts.dilation.by_force()) {
            double normal = 0, spring = 0;
            for (const dda::ContactIndex k : dilation.contacts) {
                if (!trials[k].has_normal_spring) continue;
                normal += normal_force(k, d);
                spring += trials[k].tangent.stiffness;
            }
            const double expected = dilation.slope * (normal - dilation.normal_force);
            largest = std::max(largest, spring * std::abs(expected - dilation.change));
        }
        return largest;
    }
    double violation(const std::vector<Vec6>& d) const {
        return std::max(bound_violation(d), dilation_violation(d));
    }
    int tilted() const {
        int count = 0;
        for (std::size_t k = 0; k < trials.count(); ++k) count += slides(k) && trials[k].tilt != 0;
        return count;
    }

  private:
    double bound(std::size_t k, double normal, const std::vector<Vec6>& d) const {
        if (!(normal > 0)) return 0;
        if (contacts.bounds.is_on_segment(k)) return contacts.bounds.line(k, normal, d).at(normal);
        const dda::Contact& contact = step.set.contacts[k];
        return strength(trials.law_of(k), contact.history, normal, contact.length).forward;
    }
};

/// Solves the coupling and checks that the result solves the linear system with the final friction forces, up
/// to rounding that refinement removes, and that these forces are closer to the bounds than before.
void expect_solved(SlidingWall& wall, dda::FrictionCoupling& coupling, std::vector<Vec6>& d) {
    const double before = wall.violation(d);
    const int substitutions = coupling.solve(d);
    EXPECT_GT(substitutions, 0);
    EXPECT_LE(substitutions, 12);
    wall.solver->refine(d, wall.load(), dda::full_tolerance);
    EXPECT_LE(wall.violation(d), std::max(0.05 * before, wall.trials.tolerance() / 2 * (1 + 1e-6)));
    const std::vector<Vec6> solution = wall.solution();
    double size = 0;
    for (const Vec6& of_row : solution) size = std::max(size, of_row.cwiseAbs().maxCoeff());
    for (std::size_t r = 0; r < d.size(); ++r)
        EXPECT_LT((d[r] - solution[r]).cwiseAbs().maxCoeff(), 1e-10 * size) << "row " << r;
}

class FrictionCouplingOfMovedWalls : public testing::TestWithParam<std::tuple<unsigned, dda::SolverKind>> {
  protected:
    SlidingWall wall_of(const dda::JointLaw& law) const {
        const auto [seed, kind] = GetParam();
        return {law, seed, kind};
    }
};

TEST_P(FrictionCouplingOfMovedWalls, MatchesTheBoundsAndSolvesTheSystem) {
    SlidingWall wall = wall_of(Scene::mohr_coulomb(35));
    std::vector<Vec6> d = wall.solution();
    ASSERT_GT(wall.violation(d), wall.trials.tolerance())
        << "the friction forces are at their bounds already";
    dda::FrictionCoupling coupling(wall.problem, wall.contacts, *wall.solver, wall.step.pool);
    expect_solved(wall, coupling, d);
}

// Joints whose asperities open them as they slip: their normal springs are tilted, Eq. (83), and a part of
// the dilation follows the normal force, Eq. (85).
TEST_P(FrictionCouplingOfMovedWalls, MatchesTheBoundsOfDilatingJoints) {
    SlidingWall wall = wall_of(dda::Plesha{{radians(25), radians(10), 1e-5}});
    std::vector<Vec6> d = wall.solution();
    ASSERT_GT(wall.tilted(), 20) << "sliding contacts with a tilt";
    ASSERT_GT(wall.contacts.dilation.by_force().size(), 10u);
    ASSERT_GT(wall.bound_violation(d), wall.trials.tolerance());
    ASSERT_GT(wall.dilation_violation(d), wall.trials.tolerance());
    dda::FrictionCoupling coupling(wall.problem, wall.contacts, *wall.solver, wall.step.pool);
    expect_solved(wall, coupling, d);
}
INSTANTIATE_TEST_SUITE_P(Seeds, FrictionCouplingOfMovedWalls,
                         testing::Combine(testing::Values(1u, 2u, 3u, 4u, 5u),
                                          testing::Values(dda::SolverKind::multifrontal,
                                                          dda::SolverKind::refined)));

// A block whose bounds grow as it slides: the matrix bears a part of its shear forces, Eq. (102).
TEST(FrictionCoupling, MatchesTheBoundsOfJointsThatHarden) {
    const Scene block = resting_block(dda::ContinuouslyYielding{radians(35), radians(25), 1e-3});
    SlidingWall wall(block.model, {RestingContacts::displacement(2e-5, 1e-5)});
    ASSERT_EQ(wall.trials.count(), 2u);
    for (const dda::ContactIndex k : {dda::ContactIndex(0), dda::ContactIndex(1)})
        ASSERT_GT(wall.trials[k].sliding_stiffness * wall.trials[k].held_shearing,
                  0.1 * wall.trials[k].bounds.forward);
    wall.step.base.load[0] << 3e3, -2.5e4, 1e3, 0, 0, 0;
    std::vector<Vec6> d = wall.solution();
    ASSERT_GT(wall.violation(d), 1e3);
    dda::FrictionCoupling coupling(wall.problem, wall.contacts, *wall.solver, wall.step.pool);
    expect_solved(wall, coupling, d);
}

// Where repeated solutions bring the friction forces to their bounds, another one changes nothing. Some
// other walls keep contacts whose bound is cut off at zero.
TEST(FrictionCoupling, ChangesNothingWhereTheForcesAreAtTheirBounds) {
    for (const unsigned seed : {1u, 3u, 4u}) {
        SlidingWall wall(Scene::mohr_coulomb(35), seed, dda::SolverKind::multifrontal);
        std::vector<Vec6> d = wall.solution();
        dda::FrictionCoupling coupling(wall.problem, wall.contacts, *wall.solver, wall.step.pool);
        for (int round = 0; round < 8 && wall.violation(d) > wall.trials.tolerance() / 40; ++round)
            coupling.solve(d);
        ASSERT_LE(wall.violation(d), wall.trials.tolerance() / 20) << seed;
        const std::vector<Vec6> solved = d;
        EXPECT_EQ(coupling.solve(d), 0) << seed;
        EXPECT_EQ(d, solved) << seed;
    }
}

}  // namespace
}  // namespace rockslope::friction_coupling_test
