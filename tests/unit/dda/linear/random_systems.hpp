#pragma once

#include <Eigen/Cholesky>
#include <random>
#include <vector>

#include "dda/linear/block_matrix.hpp"
#include "unit/dda/linear/dense.hpp"

namespace rockslope {

class RandomNumbers {
  public:
    explicit RandomNumbers(unsigned seed) : engine_(seed) {}
    double number() { return static_cast<double>(engine_()) / 4294967296.0 * 2 - 1; }
    int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
    dda::Vec6 vector() {
        return dda::Vec6::NullaryExpr([&] { return number(); });
    }

  private:
    std::mt19937 engine_;
};

/// A random graph and, on it, a matrix of springs between random measures of two blocks, with a mass on the
/// diagonal: positive definite.
struct RandomSystem {
    dda::BlockPattern pattern;
    dda::BlockMatrix matrix;
    std::vector<dda::Vec6> load;

    RandomSystem(int size, int springs, unsigned seed, double mass = 0.1) {
        RandomNumbers draw(seed);
        std::vector<std::pair<int, int>> pairs;
        for (int k = 0; k < springs && size > 1; ++k) {
            const int i = draw.below(size);
            const int j = draw.below(size);
            if (i != j) pairs.emplace_back(i, j);
        }
        pattern = dda::BlockPattern::from_pairs(size, pairs);
        matrix.reset(pattern);
        for (auto& diagonal : matrix.diagonal) diagonal = mass * dda::Mat6::Identity();
        for (const auto& [i, j] : pairs) {
            const dda::Vec6 a = draw.vector();
            const dda::Vec6 b = draw.vector();
            matrix.diagonal[static_cast<std::size_t>(i)] += a * a.transpose();
            matrix.diagonal[static_cast<std::size_t>(j)] += b * b.transpose();
            matrix.add_outer(pattern, i, j, a, b);
        }
        for (int i = 0; i < size; ++i) load.push_back(draw.vector());
    }

    /// Difference from a dense solution, relative to the solution's size.
    double error_of(const std::vector<dda::Vec6>& solution) const {
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

/// Neighbours on a grid.
inline std::vector<std::pair<int, int>> grid_graph(int columns, int rows) {
    std::vector<std::pair<int, int>> pairs;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            if (c + 1 < columns) pairs.emplace_back(r * columns + c, r * columns + c + 1);
            if (r + 1 < rows) pairs.emplace_back(r * columns + c, (r + 1) * columns + c);
        }
    }
    return pairs;
}

}  // namespace rockslope
