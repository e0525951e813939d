#pragma once

#include <vector>

#include "dda/linear/block_matrix.hpp"

namespace rockslope::dda {

/// Blocks with consecutive pivots whose columns of the factor have the same rows below the supernode. They
/// form one dense front.
struct Supernode {
    int first = 0;          ///< position of its first block in the elimination order
    int pivots = 0;         ///< number of blocks that it eliminates
    std::vector<int> rows;  ///< positions of the later blocks in its columns of the factor, ascending
    int parent = -1;        ///< the supernode that eliminates the first of `rows`; -1 for a root
};

/// The assembly tree of a factorisation.
struct SupernodeTree {
    std::vector<int> order;        ///< order[k] is the block eliminated k-th
    std::vector<Supernode> nodes;  ///< in postorder: each subtree is contiguous, its root last
};

/// Number of 6x6 submatrices of the factor, on and below the diagonal, zeros of merged supernodes included.
double factor_submatrices(const SupernodeTree& tree);

/// Predicted time to factorise a front on one thread, ns. Used only for comparisons.
double front_cost(int pivots, int rows);

/// Finds the fundamental supernodes of a postorder, then merges a supernode with its parent where one front
/// is predicted to take less time than two, zeros included (relaxed supernodes). The order changes within
/// merged supernodes.
/// @param order postorder of the elimination tree; order[k] is the block eliminated k-th.
SupernodeTree find_supernodes(const BlockPattern& pattern, const std::vector<int>& order);

}  // namespace rockslope::dda
