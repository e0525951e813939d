#include "dda/linear/envelope_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "support/random_shapes.hpp"

namespace rockslope::envelope_lu_test {
namespace {

using rockslope::dda::EnvelopeLu;
using rockslope::dda::Mat6;
using rockslope::dda::Vec6;
using rockslope::scene::RandomSource;

/// A matrix in an envelope, and the same one in full.
struct Matrix {
    EnvelopeLu factors;
    Eigen::MatrixXd full;
};

Matrix random_matrix(const std::vector<int>& last, RandomSource& random) {
    const int size = static_cast<int>(last.size());
    Matrix matrix{{}, Eigen::MatrixXd::Zero(6 * size, 6 * size)};
    matrix.factors.reset(last);
    const auto add = [&](int i, int j, double diagonal) {
        Mat6 part = Mat6::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random.between(-1, 1); });
        part.diagonal().array() += diagonal;
        matrix.factors.add(i, j, part);
        matrix.full.block<6, 6>(6 * i, 6 * j) += part;
    };
    for (int i = 0; i < size; ++i) {
        add(i, i, 0);
        for (int j = i + 1; j <= last[i]; ++j) {
            add(i, j, 0);
            add(j, i, 0);
        }
        add(i, i, 0.5);
    }
    return matrix;
}

TEST(EnvelopeLu, SolvesAndTellsTheSignOfTheDeterminant) {
    RandomSource random(7);
    int negative = 0;
    for (const std::vector<int>& last :
         {std::vector<int>{0}, {0, 1, 2}, {1, 1, 3, 3}, {2, 4, 4, 5, 6, 6, 6}, {5, 5, 5, 5, 5, 5}}) {
        for (int repetition = 0; repetition < 20; ++repetition) {
            Matrix matrix = random_matrix(last, random);
            const Eigen::FullPivLU<Eigen::MatrixXd> expected(matrix.full);
            const int sign = matrix.factors.factorize();
            EXPECT_EQ(sign, expected.determinant() > 0 ? 1 : -1);
            negative += sign < 0 ? 1 : 0;
            std::vector<Vec6> x(last.size());
            Eigen::VectorXd load(6 * last.size());
            for (Eigen::Index k = 0; k < load.size(); ++k) load[k] = std::sin(1.0 + static_cast<double>(k));
            for (std::size_t k = 0; k < x.size(); ++k)
                x[k] = load.segment<6>(6 * static_cast<Eigen::Index>(k));
            matrix.factors.solve(x);
            const Eigen::Map<const Eigen::VectorXd> found(x[0].data(), load.size());
            const double scale = matrix.full.norm() * found.norm();
            EXPECT_LT((matrix.full * found - load).norm(), 1e-8 * scale)
                << "rounding, which grows by the pivots that are taken as they come";
        }
    }
    EXPECT_GT(negative, 20) << "both signs are to occur";
}

TEST(EnvelopeLu, TellsThatAMatrixIsSingular) {
    EnvelopeLu factors;
    factors.reset(std::vector<int>{1, 1});
    factors.add(0, 0, Mat6::Identity());
    EXPECT_EQ(factors.factorize(), 0);
}

}  // namespace
}  // namespace rockslope::envelope_lu_test
