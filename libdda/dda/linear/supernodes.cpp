#include "dda/linear/supernodes.hpp"

#include <algorithm>
#include <utility>

#include "dda/linear/elimination_tree.hpp"

namespace rockslope::dda {

namespace {

/// Measured on fronts of 1 to 40 blocks in single precision, on a core that does 32 multiply-adds a cycle.
constexpr double per_front = 150;     ///< ns
constexpr double per_pivot = 60;      ///< ns: the divisions and roots of a 6x6 submatrix wait for each other
constexpr double flops_per_ns = 60;   ///< of a front's dense work
constexpr double per_assembled = 12;  ///< ns for a 6x6 submatrix handed to the parent

/// For each place, the later places that its column of the factor reaches. Only those of the first column of
/// a supernode are kept.
struct Columns {
    std::vector<std::vector<int>> reach;
    std::vector<char> starts;  ///< whether the column is the first of a supernode
};

std::vector<std::vector<int>> later_neighbours(const BlockPattern& pattern, const std::vector<int>& place) {
    std::vector<std::vector<int>> later(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const auto [first, last] = std::minmax(
                place[i], place[static_cast<std::size_t>(pattern.columns[static_cast<std::size_t>(k)])]);
            later[static_cast<std::size_t>(first)].push_back(last);
        }
    }
    return later;
}

Columns find_columns(const BlockPattern& pattern, const std::vector<int>& order,
                     const std::vector<int>& parent) {
    Columns columns;
    columns.reach = later_neighbours(pattern, inverse_permutation(order));
    const std::size_t size = order.size();
    columns.starts.assign(size, 1);
    std::vector<std::vector<std::size_t>> children(size);
    std::vector<int> seen_by(size, -1);
    for (std::size_t j = 0; j < size; ++j) {
        std::vector<int>& reach = columns.reach[j];
        for (const int row : reach) seen_by[static_cast<std::size_t>(row)] = static_cast<int>(j);
        seen_by[j] = static_cast<int>(j);
        for (const std::size_t child : children[j]) {
            for (const int row : columns.reach[child]) {
                if (std::exchange(seen_by[static_cast<std::size_t>(row)], static_cast<int>(j)) !=
                    static_cast<int>(j))
                    reach.push_back(row);
            }
        }
        std::sort(reach.begin(), reach.end());
        // The only child, the column before, reaches the same rows and this one: it is of the same supernode.
        if (children[j].size() == 1 && children[j][0] + 1 == j &&
            columns.reach[j - 1].size() == reach.size() + 1)
            columns.starts[j] = 0;
        for (const std::size_t child : children[j]) {
            if (!columns.starts[child]) std::vector<int>().swap(columns.reach[child]);
        }
        if (parent[j] >= 0) children[static_cast<std::size_t>(parent[j])].push_back(j);
    }
    return columns;
}

/// A supernode while it is being merged with others.
struct Candidate {
    std::vector<int> columns;  ///< places in the old order
    std::vector<int> rows;     ///< places in the old order, ascending
    std::vector<std::size_t> children;
    bool is_merged = false;
    double cost() const {
        return front_cost(static_cast<int>(columns.size()), static_cast<int>(rows.size()));
    }
};

std::vector<Candidate> fundamental_supernodes(const BlockPattern& pattern, const std::vector<int>& order) {
    const std::vector<int> parent = elimination_tree(pattern, inverse_permutation(order));
    Columns columns = find_columns(pattern, order, parent);
    std::vector<Candidate> found;
    std::vector<std::size_t> supernode_of(order.size());
    for (std::size_t j = 0; j < order.size(); ++j) {
        if (columns.starts[j]) {
            found.emplace_back();
            found.back().rows = std::move(columns.reach[j]);
        }
        found.back().columns.push_back(static_cast<int>(j));
        supernode_of[j] = found.size() - 1;
    }
    for (std::size_t s = 0; s < found.size(); ++s) {
        Candidate& node = found[s];
        node.rows.erase(node.rows.begin(), node.rows.begin() + static_cast<long>(node.columns.size()) - 1);
        const int up = parent[static_cast<std::size_t>(node.columns.back())];
        if (up >= 0) found[supernode_of[static_cast<std::size_t>(up)]].children.push_back(s);
    }
    return found;
}

/// Lets a supernode absorb those of its children, and of theirs, that are cheaper within it.
void merge_children(std::vector<Candidate>& nodes, std::size_t parent) {
    Candidate& node = nodes[parent];
    std::vector<std::size_t> pending = std::move(node.children);
    node.children.clear();
    for (std::size_t i = 0; i < pending.size(); ++i) {
        Candidate& child = nodes[pending[i]];
        const double merged_cost = front_cost(static_cast<int>(child.columns.size() + node.columns.size()),
                                              static_cast<int>(node.rows.size()));
        if (merged_cost > child.cost() + node.cost()) {
            node.children.push_back(pending[i]);
            continue;
        }
        child.is_merged = true;
        child.columns.insert(child.columns.end(), node.columns.begin(), node.columns.end());
        node.columns = std::move(child.columns);
        pending.insert(pending.end(), child.children.begin(), child.children.end());
    }
}

}  // namespace

double front_cost(int pivots, int rows) {
    const double k = 6.0 * pivots;
    const double m = 6.0 * rows;
    const double flops = k * k * k / 3 + k * k * m + k * m * m;
    return per_front + per_pivot * pivots + flops / flops_per_ns + per_assembled * rows * rows / 2;
}

double factor_submatrices(const SupernodeTree& tree) {
    double sum = 0;
    for (const Supernode& node : tree.nodes)
        sum += node.pivots * ((node.pivots + 1) / 2.0 + static_cast<double>(node.rows.size()));
    return sum;
}

SupernodeTree find_supernodes(const BlockPattern& pattern, const std::vector<int>& order) {
    std::vector<Candidate> candidates = fundamental_supernodes(pattern, order);
    for (std::size_t s = 0; s < candidates.size(); ++s) merge_children(candidates, s);

    SupernodeTree tree;
    std::vector<int> place(order.size());  // by place in the old order
    std::vector<int> node_of(candidates.size(), -1);
    for (std::size_t s = 0; s < candidates.size(); ++s) {
        Candidate& candidate = candidates[s];
        if (candidate.is_merged) continue;
        node_of[s] = static_cast<int>(tree.nodes.size());
        Supernode node;
        node.first = static_cast<int>(tree.order.size());
        node.pivots = static_cast<int>(candidate.columns.size());
        node.rows = std::move(candidate.rows);
        for (const int column : candidate.columns) {
            place[static_cast<std::size_t>(column)] = static_cast<int>(tree.order.size());
            tree.order.push_back(order[static_cast<std::size_t>(column)]);
        }
        for (const std::size_t child : candidate.children)
            tree.nodes[static_cast<std::size_t>(node_of[child])].parent = node_of[s];
        tree.nodes.push_back(std::move(node));
    }
    for (Supernode& node : tree.nodes) {
        for (int& row : node.rows) row = place[static_cast<std::size_t>(row)];
        std::sort(node.rows.begin(), node.rows.end());
    }
    return tree;
}

}  // namespace rockslope::dda
