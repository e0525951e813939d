#include <metis.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "dda/linear/elimination_tree.hpp"
#include "dda/linear/linear_solver.hpp"

namespace rockslope::dda {

namespace {

std::vector<int> nested_dissection(const BlockPattern& pattern) {
    const std::size_t size = pattern.size;
    std::vector<int> order(size);
    std::iota(order.begin(), order.end(), 0);
    if (pattern.columns.empty()) return order;

    std::vector<idx_t> start(size + 1, 0);
    for (std::size_t i = 0; i < size; ++i) {
        start[i + 1] += pattern.start[i + 1] - pattern.start[i];
        for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            ++start[pattern.columns[k] + 1];
        }
    }
    for (std::size_t i = 0; i < size; ++i) start[i + 1] += start[i];
    std::vector<idx_t> neighbours(start[size]);
    std::vector<idx_t> filled(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const RowIndex j = pattern.columns[k];
            neighbours[filled[i]++] = j.value();
            neighbours[filled[j]++] = static_cast<idx_t>(i);
        }
    }

    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    idx_t count = static_cast<idx_t>(size);
    std::vector<idx_t> permutation(size);
    std::vector<idx_t> inverse(size);
    if (METIS_NodeND(&count, start.data(), neighbours.data(), nullptr, options, permutation.data(),
                     inverse.data()) != METIS_OK) {
        throw std::runtime_error("METIS could not order the blocks");
    }
    order.assign(permutation.begin(), permutation.end());
    return order;
}

/// Postorder of a forest: children before their parent, each subtree contiguous.
std::vector<int> postorder(const std::vector<int>& parent) {
    const std::size_t size = parent.size();
    std::vector<std::vector<int>> children(size + 1);  // those of node `size` are the roots
    for (std::size_t k = 0; k < size; ++k) children[parent[k] < 0 ? size : parent[k]].push_back(k);
    std::vector<int> visited;
    visited.reserve(size + 1);
    std::vector<int> stack{static_cast<int>(size)};
    while (!stack.empty()) {  // preorder with the last child first, which is the postorder reversed
        const int node = stack.back();
        stack.pop_back();
        visited.push_back(node);
        const auto& below = children[node];
        stack.insert(stack.end(), below.begin(), below.end());
    }
    std::reverse(visited.begin(), visited.end());
    visited.pop_back();
    return visited;
}

}  // namespace

std::vector<int> fill_reducing_order(const BlockPattern& pattern) {
    const std::vector<int> order = nested_dissection(pattern);
    std::vector<int> postordered;
    postordered.reserve(order.size());
    for (const int k : postorder(elimination_tree(pattern, inverse_permutation(order))))
        postordered.push_back(order[k]);
    return postordered;
}

}  // namespace rockslope::dda
