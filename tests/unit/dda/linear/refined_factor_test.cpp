#include "dda/linear/refined_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/linear/linear_solver.hpp"

namespace rockslope::refined_factor_test {
namespace {

using dda::Vec6;

const ThreadPool serial(1);

/// The system of one block whose first two rows are nearly equal: (1, 1) and (1, 1 + difference).
struct NearlySingular {
    dda::BlockPattern pattern = dda::BlockPattern::from_pairs(1, {});
    dda::BlockMatrix matrix;
    explicit NearlySingular(double difference) {
        matrix.reset(pattern);
        dda::Mat6& block = matrix.diagonal[0];
        block.setIdentity();
        block(0, 1) = block(1, 0) = 1;
        block(1, 1) = 1 + difference;
    }
};

const Vec6 load = (Vec6() << 1, 2, 3, 4, 5, 6).finished();

// 1 + 2^-25 is 1 in single precision, so the second pivot is zero. With a shifted diagonal the factor is
// still a good preconditioner.
TEST(RefinedFactor, ShiftsTheDiagonalWhenAPivotTurnsNegative) {
    const double difference = std::ldexp(1, -25);
    const NearlySingular system(difference);
    dda::RefinedFactor factor;
    factor.analyze(system.pattern, dda::find_supernodes(system.pattern, {0}));
    ASSERT_TRUE(factor.factorize(system.matrix, serial));
    std::vector<Vec6> x{Vec6::Zero()};
    ASSERT_TRUE(factor.refine(x, std::vector<Vec6>{load}, 1e-11, serial).converged);
    // Unknowns of 3e7 have rounding errors of 4e-9, which bounds the accuracy of their sum.
    EXPECT_NEAR(x[0][1] * difference, 1, 1e-8);
    EXPECT_NEAR(x[0][0] + x[0][1], 1, 1e-7);
    EXPECT_LT((x[0].tail<4>() - load.tail<4>()).norm(), 1e-10);
}

TEST(RefinedSolver, ReturnsNanForANearlyDefiniteMatrix) {
    const NearlySingular system(-3e-8);
    const auto solver = dda::make_linear_solver(dda::SolverKind::refined, serial);
    solver->analyze(system.pattern);
    ASSERT_TRUE(solver->factorize(system.matrix)) << "the matrix is positive definite in single precision";
    std::vector<Vec6> x{load};
    solver->solve(x);
    EXPECT_TRUE(x[0].array().isNaN().all());
}

}  // namespace
}  // namespace rockslope::refined_factor_test
