#pragma once

#include <Eigen/Core>

#include "dda/linear/block_matrix.hpp"

namespace rockslope {

/// A block matrix written out in full.
inline Eigen::MatrixXd dense(const dda::BlockPattern& pattern, const dda::BlockMatrix& matrix) {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(6 * pattern.size, 6 * pattern.size);
    for (int i = 0; i < pattern.size; ++i) {
        const auto row = static_cast<std::size_t>(i);
        full.block<6, 6>(6 * i, 6 * i) = matrix.diagonal[row];
        for (int k = pattern.start[row]; k < pattern.start[row + 1]; ++k) {
            const int j = pattern.columns[static_cast<std::size_t>(k)];
            full.block<6, 6>(6 * i, 6 * j) = matrix.upper[static_cast<std::size_t>(k)];
            full.block<6, 6>(6 * j, 6 * i) = matrix.upper[static_cast<std::size_t>(k)].transpose();
        }
    }
    return full;
}

}  // namespace rockslope
