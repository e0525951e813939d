#include "dda/linear/minimal_residual.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace rockslope::minimal_residual_test {
namespace {

using rockslope::dda::MinimalResidual;

/// An unsymmetric matrix, and a right-hand side.
struct System {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right_hand_side;
};

System unsymmetric(int size) {
    System s{Eigen::MatrixXd::Identity(size, size), Eigen::VectorXd(size)};
    for (int i = 0; i < size; ++i) {
        s.right_hand_side[i] = i % 3 - 0.7;
        for (int j = 0; j < size; ++j) s.matrix(i, j) += 0.3 * std::sin(1 + 7 * i + 3 * j * j);
    }
    return s;
}

TEST(MinimalResidual, IsExactAfterAsManyDirectionsAsUnknowns) {
    for (const int size : {1, 2, 5, 12}) {
        const System s = unsymmetric(size);
        MinimalResidual found(s.right_hand_side);
        for (int k = 0; k < size; ++k) found.add(s.matrix * found.direction());
        const Eigen::VectorXd expected = s.matrix.partialPivLu().solve(s.right_hand_side);
        EXPECT_LT((found.solution() - expected).norm(), 1e-12 * expected.norm()) << "rounding; size " << size;
        EXPECT_LT(found.residual(), 1e-12 * s.right_hand_side.norm());
    }
}

TEST(MinimalResidual, TellsTheResidualOfItsSolution) {
    const System s = unsymmetric(12);
    MinimalResidual found(s.right_hand_side);
    double last = s.right_hand_side.norm();
    EXPECT_EQ(found.residual(), last);
    EXPECT_EQ(found.solution().norm(), 0);
    for (int k = 0; k < 11; ++k) {
        found.add(s.matrix * found.direction());
        const double residual = (s.matrix * found.solution() - s.right_hand_side).norm();
        EXPECT_NEAR(found.residual(), residual, 1e-13) << "rounding";
        EXPECT_LE(found.residual(), last + 1e-14) << "rounding";
        last = found.residual();
    }
}

// A multiple of the identity needs one direction: the next one has no length.
TEST(MinimalResidual, EndsWhereNoNewDirectionIsLeft) {
    MinimalResidual found(Eigen::VectorXd::LinSpaced(4, 1, 4));
    found.add(2 * found.direction());
    EXPECT_LT(found.residual(), 1e-14);
    EXPECT_LT((found.solution() - Eigen::VectorXd::LinSpaced(4, 0.5, 2)).norm(), 1e-14);
}

TEST(MinimalResidual, OfNothingIsNothing) {
    const MinimalResidual found(Eigen::VectorXd::Zero(3));
    EXPECT_EQ(found.residual(), 0);
    EXPECT_EQ(found.solution(), Eigen::VectorXd::Zero(3));
}

}  // namespace
}  // namespace rockslope::minimal_residual_test
