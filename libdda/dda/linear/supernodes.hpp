#pragma once

#include <vector>

#include "dda/linear/block_matrix.hpp"

namespace rockslope::dda {

/// Blocks that are eliminated one after the other with the same later neighbours: their columns of the factor
/// form one dense front.
struct Supernode {
    int first = 0;          ///< place of the first of its blocks in the order of elimination
    int pivots = 0;         ///< how many blocks it eliminates
    std::vector<int> rows;  ///< places of later blocks that it reaches, ascending
    int parent = -1;        ///< the supernode of the first of its rows; -1 for a root
};

/// The assembly tree of a factorisation.
struct SupernodeTree {
    std::vector<int> order;        ///< order[k] is the block eliminated k-th
    std::vector<Supernode> nodes;  ///< each subtree together, its root last
};

/// Submatrices of the factor: on and below the diagonal of the fronts.
double factor_submatrices(const SupernodeTree& tree);

/// What a front is predicted to take, ns on one thread: a figure for comparisons.
double front_cost(int pivots, int rows);

/// Finds the supernodes of an order whose subtrees are together, and merges a supernode with its parent where
/// one front is predicted to take less time than two, though it holds zeros. The order changes within merged
/// supernodes.
SupernodeTree find_supernodes(const BlockPattern& pattern, const std::vector<int>& order);

}  // namespace rockslope::dda
