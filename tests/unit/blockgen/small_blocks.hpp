#pragma once

#include <algorithm>
#include <vector>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen {

/// Areas of all blocks, ascending.
inline std::vector<double> areas(const BlockMesh& mesh) {
    std::vector<double> result;
    for (const BlockIndex b : mesh.blocks()) result.push_back(block_area(mesh, b));
    std::sort(result.begin(), result.end());
    return result;
}

/// A sliver 1/16 m high between two persistent joints; a short joint divides the rock below it.
inline SlopeModel sliver(SmallBlockPolicy policy) {
    SlopeModel model = rectangle(8, 4);
    add_trace(model, {{-1, 2}, {9, 2}}, "lower");
    add_trace(model, {{-1, 2.0625}, {9, 2.0625}}, "upper");
    add_trace(model, {{3, -1}, {3, 2}}, "wall");
    model.small_blocks = {policy, 1, 0};
    return model;
}

}  // namespace rockslope::blockgen
