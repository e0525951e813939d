#include <metis.h>

#include <numeric>
#include <stdexcept>

#include "dda/linear/linear_solver.hpp"

namespace dda {

std::vector<int> fill_reducing_order(const BlockPattern& pattern) {
    const auto size = static_cast<std::size_t>(pattern.size);
    std::vector<int> order(size);
    std::iota(order.begin(), order.end(), 0);
    if (pattern.columns.empty()) return order;

    std::vector<idx_t> start(size + 1, 0);
    for (std::size_t i = 0; i < size; ++i) {
        start[i + 1] += pattern.start[i + 1] - pattern.start[i];
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            ++start[static_cast<std::size_t>(pattern.columns[static_cast<std::size_t>(k)]) + 1];
        }
    }
    for (std::size_t i = 0; i < size; ++i) start[i + 1] += start[i];
    std::vector<idx_t> neighbours(static_cast<std::size_t>(start[size]));
    std::vector<idx_t> filled(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < size; ++i) {
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const auto j = static_cast<std::size_t>(pattern.columns[static_cast<std::size_t>(k)]);
            neighbours[static_cast<std::size_t>(filled[i]++)] = static_cast<idx_t>(j);
            neighbours[static_cast<std::size_t>(filled[j]++)] = static_cast<idx_t>(i);
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

}  // namespace dda
