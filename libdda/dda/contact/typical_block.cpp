#include "dda/contact/typical_block.hpp"

#include <algorithm>
#include <vector>

#include "dda/block/block_system.hpp"
#include "dda/contact/candidates.hpp"

namespace rockslope::dda {

std::optional<TypicalBlock> typical_block(const Model& model) {
    const BlockSystem blocks = initial_block_system(model);
    std::vector<double> masses;
    for (const BlockIndex b : model.blocks())
        if (model.motion[b] == Motion::free) masses.push_back(blocks.mass[b]);
    if (masses.empty()) return std::nullopt;
    const auto median = masses.begin() + static_cast<std::ptrdiff_t>(masses.size() / 2);
    std::nth_element(masses.begin(), median, masses.end());
    return TypicalBlock{*median, median_edge_length(model.topology, model.vertices)};
}

}  // namespace rockslope::dda
