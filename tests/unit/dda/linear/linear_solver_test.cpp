// Conformance test of all linear solvers.

#include "dda/linear/linear_solver.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "support/case_name.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"
#include "unit/dda/linear/random_systems.hpp"

namespace rockslope::linear_solver_test {
namespace {

using dda::Mat6;
using dda::Vec6;

const ThreadPool two_threads(2);

struct Kind {
    const char* name;
    dda::SolverKind kind;
    std::unique_ptr<dda::LinearSolver> make() const { return dda::make_linear_solver(kind, two_threads); }
};
const Kind solver_kinds[] = {{"simplicial", dda::SolverKind::simplicial},
                             {"multifrontal", dda::SolverKind::multifrontal},
                             {"refined", dda::SolverKind::refined}};

struct Size {
    int blocks, springs;
};

class SolversOnGraphs : public testing::TestWithParam<std::tuple<Kind, Size>> {};

// The condition number is below 1e4 by construction, so a backward stable solution has an error of some
// 1e-12.
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

TEST_P(Solvers, SolvePatternsInTurn) {
    const auto solver = GetParam().make();
    for (const int size : {20, 3, 40}) {
        const RandomSystem system(size, 2 * size, 11);
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        for (int repetition = 0; repetition < 2; ++repetition) {
            std::vector<Vec6> x = system.load;
            solver->solve(x);
            EXPECT_LT(system.error_of(x), 1e-11);
        }
    }
}

TEST_P(Solvers, RejectAnIndefiniteMatrixAndRecover) {
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

TEST_P(Solvers, RejectAZeroDiagonalBlock) {
    RandomSystem system(4, 6, 3);
    system.matrix.diagonal[2].setZero();
    for (Mat6& upper : system.matrix.upper) upper.setZero();
    const auto solver = GetParam().make();
    solver->analyze(system.pattern);
    EXPECT_FALSE(solver->factorize(system.matrix));
}

// With a mass of 1e-9 and springs of 1 the condition number is some 1e10, which leaves some 6 of 16 digits.
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
    for (int repetition = 0; repetition < 3; ++repetition) {
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
    std::vector<Vec6> remainder = system.load;
    for (std::size_t row = 0; row < system.pattern.size; ++row) {
        remainder[row] -= system.matrix.diagonal[row] * x[row];
        for (std::uint32_t k = system.pattern.start[row]; k < system.pattern.start[row + 1]; ++k) {
            const dda::RowIndex j = system.pattern.columns[k];
            remainder[row] -= system.matrix.upper[k] * x[j];
            remainder[j] -= system.matrix.upper[k].transpose() * x[row];
        }
    }
    double remainder_square = 0;
    double load_square = 0;
    for (std::size_t i = 0; i < remainder.size(); ++i) {
        remainder_square += remainder[i].squaredNorm();
        load_square += system.load[i].squaredNorm();
    }
    return std::sqrt(remainder_square / load_square);
}

// Backward stability: |b - A x| is a small multiple of the rounding of |A| |x|. With springs of 100 E and a
// step of 1 ms, |A| |x| is up to 1e5 |b|.
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

// There are fewer springs than unknowns, and the mass is lost beside them in single precision. The solver
// solves such a system in double precision and gives the same bytes.
TEST(RefinedSolver, SolvesInDoublePrecisionWhereSingleLosesTheMass) {
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

// The right-hand sides and the matrices of a step are close to each other.
TEST_P(Solvers, SolveRightHandSidesInTurn) {
    RandomSystem system(30, 90, 4);
    const auto solver = GetParam().make();
    solver->analyze(system.pattern);
    ASSERT_TRUE(solver->factorize(system.matrix));
    std::vector<Vec6> x = system.load;
    solver->solve(x);
    const std::vector<Vec6> load = system.load;
    for (const double change : {1e-9, 1e-3, 1.0, 1e3}) {
        system.matrix.diagonal[3] *= 1 + change / 1e4;
        std::vector<char> changed(30, 0);
        changed[3] = 1;
        ASSERT_TRUE(solver->refactorize(system.matrix, changed));
        for (std::size_t i = 0; i < load.size(); ++i) system.load[i] = load[i] + change * load[29 - i];
        x = system.load;
        solver->solve(x);
        EXPECT_LT(system.error_of(x), 1e-11);
        x.assign(30, Vec6::Zero());
        solver->solve(x);
        EXPECT_EQ(x, std::vector<Vec6>(30, Vec6::Zero()));
    }
}

// A coarse solution from any guess (residual below 1e-7 of the load, condition number below 1e4), plus a
// direction for a change of the load, then refinement.
TEST_P(Solvers, SolveCoarselyAddAndRefine) {
    for (const double guess : {0.0, 1.0, 1e6}) {
        RandomSystem system(60, 200, 9);
        const auto solver = GetParam().make();
        solver->analyze(system.pattern);
        ASSERT_TRUE(solver->factorize(system.matrix));
        std::vector<Vec6> x(system.load.size(), Vec6::Constant(guess));
        EXPECT_GT(solver->solve_coarsely(x, system.load), 0);
        EXPECT_LT(system.error_of(x), 1e-3);
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
}  // namespace rockslope::linear_solver_test
