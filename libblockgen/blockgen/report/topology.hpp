#pragma once

#include <cstddef>

#include "blockgen/faces/cut_context.hpp"

namespace rockslope::blockgen {

/// Numbers of nodes of the joint network inside the rock, by the number of branches (Sanderson and Nixon
/// 2015): tips (I), abutments (Y) and crossings (X); and of edge nodes, which lie on a free face.
struct NodeCounts {
    std::size_t i = 0, y = 0, x = 0, edge = 0;
};

/// How the joints in the rock hang together.
struct Topology {
    NodeCounts nodes;
    std::size_t branches = 0;    ///< pieces of joints between two nodes
    std::size_t clusters = 0;    ///< groups of joints that are connected
    double largest_cluster = 0;  ///< length of the longest group, as a share of all
};

/// Counts nodes, branches and clusters of the noded network. A closed line without a node is one branch.
Topology topology_of(const CutContext& cut);

}  // namespace rockslope::blockgen
