#include "blockgen/report/topology.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/disjoint_sets.hpp"

namespace rockslope::blockgen {

namespace {

class NetworkWalk {
  public:
    explicit NetworkWalk(const CutContext& cut)
        : cut_(cut),
          degree_(cut.noded.vertices.size(), 0),
          at_face_(cut.noded.vertices.size(), 0),
          clusters_(cut.noded.vertices.size()) {}

    Topology run() {
        for (const EdgeIndex e : cut_.noded.edges.indices()) add_edge(e);
        count_nodes();
        count_clusters();
        return topology_;
    }

  private:
    void add_edge(EdgeIndex e) {
        const bool left = cut_.is_rock(forward_half(e)), right = cut_.is_rock(backward_half(e));
        const auto& [a, b] = cut_.noded.edges[e];
        if (left != right) at_face_[a] = at_face_[b] = 1;
        if (!left || !right || !cut_.is_joint(e)) return;
        for (const NodeIndex v : {a, b})
            if (degree_[v] < 255) ++degree_[v];
        clusters_.unite(a, b);
    }

    bool is_node(NodeIndex v) const { return degree_[v] > 0 && (at_face_[v] || degree_[v] != 2); }

    /// A branch has two ends, each at a node.
    void count_nodes() {
        std::size_t ends = 0;
        NodeCounts& n = topology_.nodes;
        for (const NodeIndex v : degree_.indices()) {
            if (!is_node(v)) continue;
            ends += degree_[v];
            ++(at_face_[v] ? n.edge : degree_[v] == 1 ? n.i : degree_[v] == 3 ? n.y : n.x);
        }
        topology_.branches = ends / 2;
    }

    void count_clusters() {
        PerNode<double> length(degree_.size(), 0);
        PerNode<char> has_node(degree_.size(), 0);
        double total = 0, largest = 0;
        for (const EdgeIndex e : cut_.noded.edges.indices()) {
            if (!cut_.is_rock(forward_half(e)) || !cut_.is_rock(backward_half(e)) || !cut_.is_joint(e))
                continue;
            const auto& [a, b] = cut_.noded.edges[e];
            const GridPoint &p = cut_.noded.vertices[a], &q = cut_.noded.vertices[b];
            const double edge = std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
            const NodeIndex root = clusters_.root(a);
            total += edge;
            length[root] += edge;
            if (is_node(a) || is_node(b)) has_node[root] = 1;
        }
        for (const NodeIndex v : length.indices()) {
            if (!(length[v] > 0)) continue;
            ++topology_.clusters;
            if (!has_node[v]) ++topology_.branches;
            largest = std::max(largest, length[v]);
        }
        if (total > 0) topology_.largest_cluster = largest / total;
    }

    CutContext cut_;
    PerNode<unsigned char> degree_;  ///< number of joint edges in the rock
    PerNode<char> at_face_;
    DisjointSets clusters_;
    Topology topology_;
};

}  // namespace

Topology topology_of(const CutContext& cut) {
    return NetworkWalk(cut).run();
}

}  // namespace rockslope::blockgen
