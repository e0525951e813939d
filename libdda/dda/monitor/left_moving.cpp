#include "dda/monitor/left_moving.hpp"

#include "dda/analysis/moving_block.hpp"

namespace rockslope::dda {

std::vector<LeftMoving> left_moving(const Model& model, const State& state, const Stage& stage,
                                    int stage_index) {
    std::vector<LeftMoving> list;
    if (!stage.is_static() || stage.strength_reduction) return list;
    for (const BlockIndex block : moving_blocks(model, state, stage.tolerance)) {
        list.push_back({.stage = stage_index,
                        .block = block,
                        .centroid = state.blocks.centroid(block) + model.origin,
                        .mass = state.blocks.mass[block],
                        .share = share_of_mass(model, state, {&block, 1}),
                        .displacement = moving_block(model, state, block).displacement});
    }
    return list;
}

}  // namespace rockslope::dda
