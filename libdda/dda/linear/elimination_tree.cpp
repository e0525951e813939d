#include "dda/linear/elimination_tree.hpp"

#include <algorithm>
#include <utility>

namespace rockslope::dda {

std::vector<int> elimination_tree(const BlockPattern& pattern, const std::vector<int>& place) {
    const std::size_t size = place.size();
    std::vector<std::vector<int>> earlier(size);  // neighbours eliminated before
    for (std::size_t i = 0; i < size; ++i) {
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const auto [first, last] = std::minmax(
                place[i], place[static_cast<std::size_t>(pattern.columns[static_cast<std::size_t>(k)])]);
            earlier[static_cast<std::size_t>(last)].push_back(first);
        }
    }
    std::vector<int> parent(size, -1);
    std::vector<int> ancestor(size, -1);  // as far up as is known, to shorten the walks
    for (std::size_t k = 0; k < size; ++k) {
        for (int at : earlier[k]) {
            while (at != -1 && at != static_cast<int>(k)) {
                const auto here = static_cast<std::size_t>(at);
                at = std::exchange(ancestor[here], static_cast<int>(k));
                if (at == -1) parent[here] = static_cast<int>(k);
            }
        }
    }
    return parent;
}

std::vector<int> inverse_permutation(const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    return place;
}

}  // namespace rockslope::dda
