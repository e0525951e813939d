#include "dda/analysis/lost_blocks.hpp"

#include <algorithm>
#include <limits>

namespace rockslope::dda {

namespace {

constexpr double no_depth = -std::numeric_limits<double>::infinity();

/// The depths of a block's corners, along gravity.
struct Depths {
    double least = -no_depth;
    double largest = no_depth;
};

Depths depths_of(const Model& model, const State& state, BlockIndex block) {
    Depths depths;
    for (const CornerIndex corner : model.topology.corners_of(block)) {
        const double depth = model.gravity.dot(state.blocks.vertices[corner]);
        depths.least = std::min(depths.least, depth);
        depths.largest = std::max(depths.largest, depth);
    }
    return depths;
}

}  // namespace

std::vector<BlockIndex> note_lost_blocks(const Model& model, State& state) {
    std::vector<BlockIndex> lost;
    if (model.gravity.isZero(0)) return lost;
    double ground = no_depth;
    for (const BlockIndex block : model.blocks())
        if (model.motion[block] == Motion::fixed || model.motion[block] == Motion::prescribed)
            ground = std::max(ground, depths_of(model, state, block).largest);
    if (ground == no_depth) return lost;
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free || !state.is_present(block)) continue;
        if (!(depths_of(model, state, block).least > ground)) continue;
        const bool is_noted = std::any_of(state.lost_blocks.begin(), state.lost_blocks.end(),
                                          [&](const LostBlock& noted) { return noted.block == block; });
        if (is_noted) continue;
        lost.push_back(block);
        state.lost_blocks.push_back({block, state.time, state.blocks.centroid(block)});
    }
    return lost;
}

}  // namespace rockslope::dda
