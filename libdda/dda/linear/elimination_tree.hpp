#pragma once

#include <vector>

#include "dda/linear/block_matrix.hpp"

namespace rockslope::dda {

/// The elimination tree of an order: parent[k] is the parent of the k-th eliminated block, as a position in
/// the order; -1 for a root. [Liu 1990]
/// @param position per block, its position in the order.
std::vector<int> elimination_tree(const BlockPattern& pattern, const std::vector<int>& position);

/// Position of each block in an order.
std::vector<int> inverse_permutation(const std::vector<int>& order);

}  // namespace rockslope::dda
