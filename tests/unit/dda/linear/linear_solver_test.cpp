#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "dda/linear/linear_solver.hpp"
#include "support/case_name.hpp"
#include "unit/dda/linear/dense.hpp"

namespace {

using dda::BlockMatrix;
using dda::BlockPattern;
using dda::Mat6;
using dda::Vec6;

class Draw {
  public:
    explicit Draw(unsigned seed) : engine_(seed) {}
    double number() { return static_cast<double>(engine_()) / 4294967296.0 * 2 - 1; }
    int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
    Vec6 vector() {
        return Vec6::NullaryExpr([&] { return number(); });
    }

  private:
    std::mt19937 engine_;
};

/// A random graph and, on it, a matrix of springs between random measures of two blocks, with a mass on the
/// diagonal: positive definite.
struct Problem {
    BlockPattern pattern;
    BlockMatrix matrix;
    std::vector<Vec6> load;

    Problem(int size, int springs, unsigned seed) {
        Draw draw(seed);
        std::vector<std::pair<int, int>> pairs;
        for (int k = 0; k < springs && size > 1; ++k) {
            const int i = draw.below(size);
            const int j = draw.below(size);
            if (i != j) pairs.emplace_back(i, j);
        }
        pattern = BlockPattern::from_pairs(size, pairs);
        matrix.reset(pattern);
        for (auto& diagonal : matrix.diagonal) diagonal = 0.1 * Mat6::Identity();
        for (const auto& [i, j] : pairs) {
            const Vec6 a = draw.vector();
            const Vec6 b = draw.vector();
            matrix.diagonal[static_cast<std::size_t>(i)] += a * a.transpose();
            matrix.diagonal[static_cast<std::size_t>(j)] += b * b.transpose();
            matrix.add_outer(pattern, i, j, a, b);
        }
        for (int i = 0; i < size; ++i) load.push_back(draw.vector());
    }

    /// Largest difference from a dense solution, relative to the solution's size.
    double error_of(const std::vector<Vec6>& solution) const {
        Eigen::VectorXd b(6 * pattern.size);
        Eigen::VectorXd x(6 * pattern.size);
        for (int i = 0; i < pattern.size; ++i) {
            b.segment<6>(6 * i) = load[static_cast<std::size_t>(i)];
            x.segment<6>(6 * i) = solution[static_cast<std::size_t>(i)];
        }
        const Eigen::VectorXd expected = dense(pattern, matrix).llt().solve(b);
        return (x - expected).norm() / expected.norm();
    }
};

class CholmodSizes : public testing::TestWithParam<std::pair<int, int>> {};

// The condition number is below 1e4 by construction, so a backward stable solution is right to some 1e-12.
TEST_P(CholmodSizes, AgreesWithADenseSolution) {
    const auto [size, springs] = GetParam();
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Problem problem(size, springs, seed);
        const auto solver = dda::make_cholmod_solver();
        solver->analyze(problem.pattern);
        ASSERT_TRUE(solver->factorize(problem.matrix));
        std::vector<Vec6> x = problem.load;
        solver->solve(x);
        EXPECT_LT(problem.error_of(x), 1e-11) << size << " blocks, seed " << seed;
    }
}
INSTANTIATE_TEST_SUITE_P(Graphs, CholmodSizes,
                         testing::Values(std::pair{1, 0}, std::pair{2, 1}, std::pair{5, 0}, std::pair{7, 12},
                                         std::pair{30, 60}, std::pair{60, 200}),
                         [](const auto& tested) {
                             return case_name("blocks " + case_number(tested.param.first) + " springs " +
                                              case_number(tested.param.second));
                         });

TEST(CholmodSolver, ServesOnePatternAfterAnother) {
    const auto solver = dda::make_cholmod_solver();
    for (const int size : {20, 3, 40}) {
        const Problem problem(size, 2 * size, 11);
        solver->analyze(problem.pattern);
        ASSERT_TRUE(solver->factorize(problem.matrix));
        for (int again = 0; again < 2; ++again) {
            std::vector<Vec6> x = problem.load;
            solver->solve(x);
            EXPECT_LT(problem.error_of(x), 1e-11);
        }
    }
}

TEST(CholmodSolver, RefusesAnIndefiniteMatrixAndRecovers) {
    Problem problem(12, 30, 5);
    const auto solver = dda::make_cholmod_solver();
    solver->analyze(problem.pattern);
    const Mat6 good = problem.matrix.diagonal[7];
    problem.matrix.diagonal[7](3, 3) = -1;
    EXPECT_FALSE(solver->factorize(problem.matrix));
    problem.matrix.diagonal[7] = good;
    ASSERT_TRUE(solver->factorize(problem.matrix));
    std::vector<Vec6> x = problem.load;
    solver->solve(x);
    EXPECT_LT(problem.error_of(x), 1e-11);
}

TEST(CholmodSolver, GivesTheSameBytesAgain) {
    const Problem problem(50, 150, 9);
    std::vector<std::vector<Vec6>> solutions;
    for (int again = 0; again < 2; ++again) {
        const auto solver = dda::make_cholmod_solver();
        solver->analyze(problem.pattern);
        ASSERT_TRUE(solver->factorize(problem.matrix));
        solutions.push_back(problem.load);
        solver->solve(solutions.back());
    }
    EXPECT_EQ(solutions[0], solutions[1]);
}

}  // namespace
