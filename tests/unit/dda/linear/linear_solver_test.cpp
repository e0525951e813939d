// What every linear solver has to do.

#include "dda/linear/linear_solver.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "support/case_name.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"
#include "unit/dda/linear/random_systems.hpp"

using namespace rockslope;

namespace {

using dda::Mat6;
using dda::Vec6;

const ThreadPool two_threads(2);

struct Kind {
    const char* name;
    dda::SolverKind kind;
    std::unique_ptr<dda::LinearSolver> make() const { return dda::make_linear_solver(kind, two_threads); }
};
const Kind solver_kinds[] = {{"cholmod", dda::SolverKind::cholmod},
                             {"multifrontal", dda::SolverKind::multifrontal},
                             {"refined", dda::SolverKind::refined}};

struct Size {
    int blocks, springs;
};

class SolversOnGraphs : public testing::TestWithParam<std::tuple<Kind, Size>> {};

// The condition number is below 1e4 by construction, so a backward stable solution is right to some 1e-12.
TEST_P(SolversOnGraphs, AgreeWithADenseSolution) {
    const auto& [kind, size] = GetParam();
    for (const unsigned seed : {1u, 2u, 3u}) {
        const RandomSystem system(size.blocks, size.springs, seed);
        const auto solver = kind.make();
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        std::vector<Vec6> x = system.load;
        solver->solve(x);
        EXPECT_LT(system.error_of(x), 1e-11) << size.blocks << " blocks, seed " << seed;
    }
}
INSTANTIATE_TEST_SUITE_P(Graphs, SolversOnGraphs,
                         testing::Combine(testing::ValuesIn(solver_kinds),
                                          testing::Values(Size{1, 0}, Size{2, 1}, Size{5, 0}, Size{7, 12},
                                                          Size{30, 20}, Size{30, 60}, Size{60, 200},
                                                          Size{250, 400})),
                         [](const auto& tested) {
                             const Kind& kind = std::get<0>(tested.param);
                             const Size& size = std::get<1>(tested.param);
                             return case_name(std::string(kind.name) + " blocks " + case_number(size.blocks) +
                                              " springs " + case_number(size.springs));
                         });

class Solvers : public testing::TestWithParam<Kind> {};

TEST_P(Solvers, ServeOnePatternAfterAnother) {
    const auto solver = GetParam().make();
    for (const int size : {20, 3, 40}) {
        const RandomSystem system(size, 2 * size, 11);
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        for (int again = 0; again < 2; ++again) {
            std::vector<Vec6> x = system.load;
            solver->solve(x);
            EXPECT_LT(system.error_of(x), 1e-11);
        }
    }
}

TEST_P(Solvers, RefuseAnIndefiniteMatrixAndRecover) {
    RandomSystem system(12, 30, 5);
    const auto solver = GetParam().make();
    solver->analyze(system.pattern);
    for (const int unknown : {0, 3, 5}) {
        for (const std::size_t block : {0, 7, 11}) {
            const Mat6 good = system.matrix.diagonal[block];
            system.matrix.diagonal[block](unknown, unknown) = -1;
            EXPECT_FALSE(solver->factorize(system.matrix));
            system.matrix.diagonal[block] = good;
        }
    }
    ASSERT_TRUE(solver->factorize(system.matrix));
    std::vector<Vec6> x = system.load;
    solver->solve(x);
    EXPECT_LT(system.error_of(x), 1e-11);
}

TEST_P(Solvers, RefuseAZeroDiagonalBlock) {
    RandomSystem system(4, 6, 3);
    system.matrix.diagonal[2].setZero();
    for (Mat6& upper : system.matrix.upper) upper.setZero();
    const auto solver = GetParam().make();
    solver->analyze(system.pattern);
    EXPECT_FALSE(solver->factorize(system.matrix));
}

// With a mass of 1e-9 and springs of 1 the condition number is some 1e10: of 16 digits some 6 are left.
TEST_P(Solvers, AreAccurateToTheConditionNumber) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const RandomSystem system(40, 150, seed, 1e-9);
        const auto solver = GetParam().make();
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        std::vector<Vec6> x = system.load;
        solver->solve(x);
        EXPECT_LT(system.error_of(x), 1e-5) << "seed " << seed;
    }
}

TEST_P(Solvers, GiveTheSameBytesAgain) {
    const scene::StepSystem system = scene::step_system(scene::running_bond_wall(20, 20, 10).model, 0.005);
    std::vector<std::vector<Vec6>> solutions;
    for (int again = 0; again < 3; ++again) {
        const auto solver = GetParam().make();
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        solutions.push_back(system.load);
        solver->solve(solutions.back());
    }
    EXPECT_EQ(solutions[0], solutions[1]);
    EXPECT_EQ(solutions[0], solutions[2]);
}

/// |b - A x| / |b|.
double residual(const scene::StepSystem& system, const std::vector<Vec6>& x) {
    std::vector<Vec6> left = system.load;
    for (int i = 0; i < system.pattern.size; ++i) {
        const auto row = static_cast<std::size_t>(i);
        left[row] -= system.matrix.diagonal[row] * x[row];
        for (auto k = static_cast<std::size_t>(system.pattern.start[row]);
             k < static_cast<std::size_t>(system.pattern.start[row + 1]); ++k) {
            const auto j = static_cast<std::size_t>(system.pattern.columns[k]);
            left[row] -= system.matrix.upper[k] * x[j];
            left[j] -= system.matrix.upper[k].transpose() * x[row];
        }
    }
    double rest = 0;
    double whole = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        rest += left[i].squaredNorm();
        whole += system.load[i].squaredNorm();
    }
    return std::sqrt(rest / whole);
}

// Backward stability: |b - A x| is some rounding of |A| |x|. Springs of 100 E against the mass that 1 ms
// leaves make |A| |x| up to 1e5 |b|.
TEST_P(Solvers, SolveTheStepsOfAWall) {
    for (const double penalty : {10.0, 100.0}) {
        for (const double dt : {1e-4, 1e-3, 5e-3, 0.1}) {
            int spring = 0;
            const scene::StepSystem system =
                scene::step_system(scene::running_bond_wall(18, 18, penalty).model, dt,
                                   [&](std::size_t) { return spring++ % 7 == 0; });
            const auto solver = GetParam().make();
            solver->analyze(system.pattern);
            ASSERT_TRUE(solver->factorize(system.matrix));
            std::vector<Vec6> x = system.load;
            solver->solve(x);
            EXPECT_LT(residual(system, x), 1e-10) << "penalty " << penalty << " E, dt " << dt;
        }
    }
}

// Fewer springs than unknowns, and a mass that single precision cannot see beside them: the factor is the one
// in double precision then, to the byte.
TEST(RefinedSolver, TakesDoublePrecisionWhereSingleIsTooLittle) {
    RandomSystem system(12, 40, 7, 1e-12);
    std::vector<std::vector<Vec6>> solutions;
    for (const dda::SolverKind kind : {dda::SolverKind::multifrontal, dda::SolverKind::refined}) {
        const auto solver = dda::make_linear_solver(kind, two_threads);
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        solutions.push_back(system.load);
        solver->solve(solutions.back());
        EXPECT_EQ(solver->fallbacks(), kind == dda::SolverKind::refined ? 1 : 0);
    }
    EXPECT_EQ(solutions[0], solutions[1]);
}

// A step's right-hand sides are near each other, and its matrices too: solutions that start from the one
// before are as near.
TEST_P(Solvers, SolveOneRightHandSideAfterAnother) {
    RandomSystem system(30, 90, 4);
    const auto solver = GetParam().make();
    solver->analyze(system.pattern);
    ASSERT_TRUE(solver->factorize(system.matrix));
    std::vector<Vec6> x = system.load;
    solver->solve(x);
    const std::vector<Vec6> load = system.load;
    for (const double share : {1e-9, 1e-3, 1.0, 1e3}) {
        system.matrix.diagonal[3] *= 1 + share / 1e4;
        std::vector<char> changed(30, 0);
        changed[3] = 1;
        ASSERT_TRUE(solver->refactorize(system.matrix, changed));
        for (std::size_t i = 0; i < load.size(); ++i) system.load[i] = load[i] + share * load[29 - i];
        x = system.load;
        solver->solve(x);
        EXPECT_LT(system.error_of(x), 1e-11);
        x.assign(30, Vec6::Zero());
        solver->solve(x);
        EXPECT_EQ(x, std::vector<Vec6>(30, Vec6::Zero()));
    }
}

// From anywhere to a first solution, whose residual is below 1e-5 of the load (the condition number is below
// 1e4); to it one for a change of the load; then the rounding of both is taken away.
TEST_P(Solvers, SolveCoarselyAddAndRefine) {
    for (const double guess : {0.0, 1.0, 1e6}) {
        RandomSystem system(60, 200, 9);
        const auto solver = GetParam().make();
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        std::vector<Vec6> x(system.load.size(), Vec6::Constant(guess));
        EXPECT_GT(solver->solve_coarsely(x, system.load), 0);
        EXPECT_LT(system.error_of(x), 1e-1);
        std::vector<Vec6> change(system.load.rbegin(), system.load.rend());
        for (std::size_t i = 0; i < change.size(); ++i) system.load[i] += change[i];
        solver->apply_factor(change);
        for (std::size_t i = 0; i < change.size(); ++i) x[i] += change[i];
        solver->refine(x, system.load, dda::full_tolerance);
        EXPECT_LT(system.error_of(x), 1e-11) << "from " << guess;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Solvers, testing::ValuesIn(solver_kinds),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
