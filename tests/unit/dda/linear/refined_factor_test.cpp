#include "dda/linear/refined_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/linear/linear_solver.hpp"

using namespace rockslope;

namespace {

using dda::Vec6;

const ThreadPool alone(1);

/// Of one block whose first two unknowns are nearly the same: 1 and 1 on one row, 1 and 1 + `apart` on the
/// other.
struct NearlySingular {
    dda::BlockPattern pattern = dda::BlockPattern::from_pairs(1, {});
    dda::BlockMatrix matrix;
    explicit NearlySingular(double apart) {
        matrix.reset(pattern);
        dda::Mat6& block = matrix.diagonal[0];
        block.setIdentity();
        block(0, 1) = block(1, 0) = 1;
        block(1, 1) = 1 + apart;
    }
};

const Vec6 load = (Vec6() << 1, 2, 3, 4, 5, 6).finished();

// 1 + 2^-25 is 1 in single precision, and the second pivot zero; held up, the factor preconditions as well.
TEST(RefinedFactor, ShiftsTheDiagonalWhenAPivotTurnsNegative) {
    const double apart = std::ldexp(1, -25);
    const NearlySingular system(apart);
    dda::RefinedFactor factor;
    factor.analyze(system.pattern, dda::find_supernodes(system.pattern, {0}));
    ASSERT_TRUE(factor.factorize(system.matrix, alone));
    std::vector<Vec6> x{Vec6::Zero()};
    ASSERT_TRUE(factor.refine(x, std::vector<Vec6>{load}, 1e-11, alone).converged);
    // Unknowns of 3e7 are rounded by 4e-9, and no sum of theirs can be nearer to its load.
    EXPECT_NEAR(x[0][1] * apart, 1, 1e-8);
    EXPECT_NEAR(x[0][0] + x[0][1], 1, 1e-7);
    EXPECT_LT((x[0].tail<4>() - load.tail<4>()).norm(), 1e-10);
}

TEST(RefinedSolver, ReturnsNanForANearlyDefiniteMatrix) {
    const NearlySingular system(-3e-8);
    const auto solver = dda::make_linear_solver(dda::SolverKind::refined, alone);
    solver->analyze(system.pattern);
    ASSERT_TRUE(solver->factorize(system.matrix)) << "in single precision it looks definite";
    std::vector<Vec6> x{load};
    solver->solve(x);
    EXPECT_TRUE(x[0].array().isNaN().all());
}

}  // namespace
