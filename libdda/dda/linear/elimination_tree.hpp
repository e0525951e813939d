#pragma once

#include <vector>

#include "dda/linear/block_matrix.hpp"

namespace rockslope::dda {

/// The parent of each block in the elimination tree of a given order, by places in it; -1 for a root. [Liu
/// 1990]
/// @param place per block, where it stands in the order.
std::vector<int> elimination_tree(const BlockPattern& pattern, const std::vector<int>& place);

/// Where each block stands in an order.
std::vector<int> inverse_permutation(const std::vector<int>& order);

}  // namespace rockslope::dda
