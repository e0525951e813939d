#pragma once

#include <Eigen/Cholesky>
#include <random>
#include <vector>

#include "dda/linear/block_matrix.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/linear/supernodes.hpp"
#include "unit/dda/linear/dense.hpp"

namespace rockslope {

/// The supernodes of a pattern in the fill-reducing order.
inline dda::SupernodeTree tree_of(const dda::BlockPattern& pattern) {
    return dda::find_supernodes(pattern, dda::fill_reducing_order(pattern));
}

class RandomNumbers {
  public:
    explicit RandomNumbers(unsigned seed) : engine_(seed) {}
    /// Uniform in [-1, 1).
    double number() { return static_cast<double>(engine_()) / 4294967296.0 * 2 - 1; }
    /// Integer in [0, limit).
    int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
    dda::Vec6 vector() {
        return dda::Vec6::NullaryExpr([&] { return number(); });
    }

  private:
    std::mt19937 engine_;
};

/// A positive definite system on a random graph: each edge is a spring between random linear functionals of
/// its two blocks, and the diagonal has a mass.
struct RandomSystem {
    dda::BlockPattern pattern;
    dda::BlockMatrix matrix;
    std::vector<dda::Vec6> load;

    RandomSystem(int size, int springs, unsigned seed, double mass = 0.1) {
        RandomNumbers draw(seed);
        std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
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
            matrix.diagonal[i] += a * a.transpose();
            matrix.diagonal[j] += b * b.transpose();
            matrix.add_outer(pattern, i, j, a, b);
        }
        for (int i = 0; i < size; ++i) load.push_back(draw.vector());
    }

    /// Difference from a dense solution, relative to the norm of the solution.
    double error_of(const std::vector<dda::Vec6>& solution) const {
        Eigen::VectorXd b(6 * pattern.size);
        Eigen::VectorXd x(6 * pattern.size);
        for (std::size_t i = 0; i < pattern.size; ++i) {
            b.segment<6>(6 * i) = load[i];
            x.segment<6>(6 * i) = solution[i];
        }
        const Eigen::VectorXd expected = dense(pattern, matrix).llt().solve(b);
        return (x - expected).norm() / expected.norm();
    }
};

/// Pairs of neighbours on a grid.
inline std::vector<std::pair<dda::RowIndex, dda::RowIndex>> grid_graph(int columns, int rows) {
    std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            if (c + 1 < columns) pairs.emplace_back(r * columns + c, r * columns + c + 1);
            if (r + 1 < rows) pairs.emplace_back(r * columns + c, (r + 1) * columns + c);
        }
    }
    return pairs;
}

}  // namespace rockslope
