#include "dda/linear/elimination_tree.hpp"

#include <algorithm>
#include <utility>

namespace rockslope::dda {

std::vector<int> elimination_tree(const BlockPattern& pattern, const std::vector<int>& position) {
    const std::size_t size = position.size();
    std::vector<std::vector<int>> earlier(size);  // neighbours eliminated before
    for (std::size_t i = 0; i < size; ++i) {
        for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const auto [first, last] = std::minmax(position[i], position[pattern.columns[k]]);
            earlier[last].push_back(first);
        }
    }
    std::vector<int> parent(size, -1);
    std::vector<int> ancestor(size, -1);  // path compression
    for (std::size_t k = 0; k < size; ++k) {
        for (int node : earlier[k]) {
            while (node != -1 && node != static_cast<int>(k)) {
                const int current = node;
                node = std::exchange(ancestor[current], static_cast<int>(k));
                if (node == -1) parent[current] = static_cast<int>(k);
            }
        }
    }
    return parent;
}

std::vector<int> inverse_permutation(const std::vector<int>& order) {
    std::vector<int> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<int>(k);
    return position;
}

}  // namespace rockslope::dda
