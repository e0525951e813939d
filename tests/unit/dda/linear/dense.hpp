#pragma once

#include <Eigen/Core>

#include "dda/linear/block_matrix.hpp"

namespace rockslope {

/// A block matrix written out in full.
inline Eigen::MatrixXd dense(const dda::BlockPattern& pattern, const dda::BlockMatrix& matrix) {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(6 * pattern.size, 6 * pattern.size);
    for (std::size_t i = 0; i < pattern.size; ++i) {
        full.block<6, 6>(6 * i, 6 * i) = matrix.diagonal[i];
        for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const std::size_t j = pattern.columns[k];
            full.block<6, 6>(6 * i, 6 * j) = matrix.upper[k];
            full.block<6, 6>(6 * j, 6 * i) = matrix.upper[k].transpose();
        }
    }
    return full;
}

}  // namespace rockslope
