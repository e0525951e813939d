#include "dda/monitor/farthest_block.hpp"

namespace rockslope::dda {

std::optional<FarthestBlock> farthest_block(const Model& model, const State& state, const Vec2& reference) {
    std::optional<FarthestBlock> farthest;
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free || !state.is_present(block)) continue;
        const double distance =
            (state.blocks.centroid(block) - state.centroid_origin[block] - reference).norm();
        if (!farthest || distance > farthest->displacement)
            farthest = FarthestBlock{block, distance, state.time};
    }
    return farthest;
}

}  // namespace rockslope::dda
