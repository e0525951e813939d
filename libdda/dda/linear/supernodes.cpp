#include "dda/linear/supernodes.hpp"

#include <algorithm>
#include <utility>

#include "dda/linear/elimination_tree.hpp"

namespace rockslope::dda {

namespace {

/// Measured on fronts of 1 to 40 blocks in single precision, on a core that does 32 multiply-adds a cycle.
constexpr double per_front = 150;     ///< ns
constexpr double per_pivot = 60;      ///< ns for the divisions and roots of a 6x6 submatrix, a serial chain
constexpr double flops_per_ns = 60;   ///< in the dense work of a front
constexpr double per_assembled = 12;  ///< ns for a 6x6 submatrix of the update, added to the parent

/// Row structure of the columns of the factor, by positions in the elimination order.
struct Columns {
    std::vector<std::vector<int>> rows;  ///< below the diagonal; kept for first columns of supernodes only
    std::vector<char> is_first_of_supernode;
};

std::vector<std::vector<int>> later_neighbours(const BlockPattern& pattern,
                                               const std::vector<int>& position) {
    std::vector<std::vector<int>> later(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
        for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const auto [first, last] = std::minmax(position[i], position[pattern.columns[k]]);
            later[first].push_back(last);
        }
    }
    return later;
}

Columns find_columns(const BlockPattern& pattern, const std::vector<int>& order,
                     const std::vector<int>& parent) {
    Columns columns;
    columns.rows = later_neighbours(pattern, inverse_permutation(order));
    const std::size_t size = order.size();
    columns.is_first_of_supernode.assign(size, 1);
    std::vector<std::vector<std::size_t>> children(size);
    std::vector<int> seen_by(size, -1);
    for (std::size_t j = 0; j < size; ++j) {
        std::vector<int>& rows = columns.rows[j];
        for (const int row : rows) seen_by[row] = static_cast<int>(j);
        seen_by[j] = j;
        for (const std::size_t child : children[j]) {
            for (const int row : columns.rows[child]) {
                if (std::exchange(seen_by[row], static_cast<int>(j)) != static_cast<int>(j))
                    rows.push_back(row);
            }
        }
        std::sort(rows.begin(), rows.end());
        // Column j - 1 is the only child of j, and its rows are j and the rows of j: one supernode.
        if (children[j].size() == 1 && children[j][0] + 1 == j &&
            columns.rows[j - 1].size() == rows.size() + 1)
            columns.is_first_of_supernode[j] = 0;
        for (const std::size_t child : children[j]) {
            if (!columns.is_first_of_supernode[child]) std::vector<int>().swap(columns.rows[child]);
        }
        if (parent[j] >= 0) children[parent[j]].push_back(j);
    }
    return columns;
}

/// A supernode during merging.
struct Candidate {
    std::vector<int> columns;  ///< positions in the old order
    std::vector<int> rows;     ///< positions in the old order, ascending
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
        if (columns.is_first_of_supernode[j]) {
            found.emplace_back();
            found.back().rows = std::move(columns.rows[j]);
        }
        found.back().columns.push_back(j);
        supernode_of[j] = found.size() - 1;
    }
    for (std::size_t s = 0; s < found.size(); ++s) {
        Candidate& node = found[s];
        const auto own = static_cast<std::ptrdiff_t>(node.columns.size()) - 1;  // 0 where there is no row
        node.rows.erase(node.rows.begin(), node.rows.begin() + own);
        const int up = parent[node.columns.back()];
        if (up >= 0) found[supernode_of[up]].children.push_back(s);
    }
    return found;
}

/// Merges a supernode with each descendant that is cheaper within it, as long as the descendant's ancestors
/// up to the supernode are merged too.
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
    std::vector<int> new_position(order.size());  // by position in the old order
    std::vector<int> node_of(candidates.size(), -1);
    for (std::size_t s = 0; s < candidates.size(); ++s) {
        Candidate& candidate = candidates[s];
        if (candidate.is_merged) continue;
        node_of[s] = tree.nodes.size();
        Supernode node;
        node.first = tree.order.size();
        node.pivots = candidate.columns.size();
        node.rows = std::move(candidate.rows);
        for (const int column : candidate.columns) {
            new_position[column] = tree.order.size();
            tree.order.push_back(order[column]);
        }
        for (const std::size_t child : candidate.children) tree.nodes[node_of[child]].parent = node_of[s];
        tree.nodes.push_back(std::move(node));
    }
    for (Supernode& node : tree.nodes) {
        for (int& row : node.rows) row = new_position[row];
        std::sort(node.rows.begin(), node.rows.end());
    }
    return tree;
}

}  // namespace rockslope::dda
