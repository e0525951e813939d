#include "dda/linear/block_matrix.hpp"

#include <gtest/gtest.h>

#include "unit/dda/linear/random_systems.hpp"

namespace rockslope::block_matrix_test {
namespace {

using dda::BlockMatrix;
using dda::BlockPattern;
using dda::Vec6;

TEST(BlockPattern, SortsSwapsAndDropsRepetitions) {
    const BlockPattern pattern = BlockPattern::from_pairs(4, {{3, 0}, {1, 2}, {0, 3}, {0, 1}, {2, 1}});
    EXPECT_EQ(pattern.size, 4);
    EXPECT_EQ(pattern.start, (std::vector<std::uint32_t>{0, 2, 3, 3, 3}));
    EXPECT_EQ(pattern.columns, (std::vector<dda::RowIndex>{1, 3, 2}));
}

TEST(BlockPattern, FindsThePositionsOfItsEntries) {
    const BlockPattern pattern = BlockPattern::from_pairs(5, {{0, 4}, {0, 2}, {1, 4}, {3, 4}});
    for (std::size_t row = 0; row < pattern.size; ++row) {
        for (std::uint32_t k = pattern.start[row]; k < pattern.start[row + 1]; ++k) {
            EXPECT_EQ(pattern.position(row, pattern.columns[k]), k);
        }
    }
}

TEST(BlockPattern, WithoutPairs) {
    EXPECT_EQ(BlockPattern::from_pairs(0, {}).start, std::vector<std::uint32_t>{0});
    EXPECT_EQ(BlockPattern::from_pairs(3, {}).start, (std::vector<std::uint32_t>{0, 0, 0, 0}));
}

TEST(BlockPattern, DoesNotDependOnTheOrderOfPairs) {
    EXPECT_EQ(BlockPattern::from_pairs(3, {{0, 1}, {1, 2}}),
              BlockPattern::from_pairs(3, {{2, 1}, {1, 0}, {0, 1}}));
}

// The larger matrix has several chunks of rows, with entries that cross them.
TEST(BlockMatrix, MultipliesLikeADenseMatrixOnAnyNumberOfThreads) {
    for (const int size : {20, 300}) {
        const RandomSystem system(size, 3 * size, 3);
        const auto rows = static_cast<std::size_t>(size);
        std::vector<Vec6> product(rows);
        system.matrix.multiply(system.pattern, system.load, product);
        Eigen::VectorXd x(6 * size);
        Eigen::VectorXd y(6 * size);
        for (int i = 0; i < size; ++i) {
            x.segment<6>(6 * i) = system.load[i];
            y.segment<6>(6 * i) = product[i];
        }
        EXPECT_LT((y - dense(system.pattern, system.matrix) * x).norm(), 1e-13 * y.norm());
        for (const int threads : {2, 3}) {
            std::vector<Vec6> parallel_product(rows);
            system.matrix.multiply(system.pattern, system.load, parallel_product, ThreadPool(threads));
            EXPECT_EQ(parallel_product, product);
        }
    }
}

TEST(BlockMatrix, AddsOuterProductsAboveAndBelowTheDiagonal) {
    const BlockPattern pattern = BlockPattern::from_pairs(3, {{0, 2}, {1, 2}});
    const Vec6 first = (Vec6() << 1, 2, 3, 4, 5, 6).finished();
    const Vec6 second = (Vec6() << -1, 0, 2, 0, 7, 1).finished();
    BlockMatrix matrix;
    matrix.reset(pattern);
    matrix.add_outer(pattern, 0, 2, first, second);
    matrix.add_outer(pattern, 2, 1, first, second);
    matrix.add_outer(pattern, 2, 1, first, second);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(18, 18);
    expected.block<6, 6>(0, 12) += first * second.transpose();
    expected.block<6, 6>(12, 6) += 2 * first * second.transpose();
    expected = (expected + expected.transpose()).eval();
    EXPECT_EQ(dense(pattern, matrix), expected);
}

TEST(BlockMatrix, ResetClearsAllEntries) {
    const BlockPattern pattern = BlockPattern::from_pairs(2, {{0, 1}});
    BlockMatrix matrix;
    matrix.reset(pattern);
    matrix.add_outer(pattern, 0, 1, Vec6::Ones(), Vec6::Ones());
    matrix.diagonal[1].setOnes();
    matrix.reset(pattern);
    EXPECT_TRUE(dense(pattern, matrix).isZero(0));
}

}  // namespace
}  // namespace rockslope::block_matrix_test
