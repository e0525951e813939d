#pragma once

#include <optional>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The free block that has moved farthest.
struct FarthestBlock {
    BlockIndex block;
    double displacement = 0;  ///< m, of its centroid, less that of the reference
    double time = 0;          ///< s
};

/// The farthest of the free blocks that are present; the first of equal ones; nothing where there is none.
/// @param reference displacement of the reference, m.
std::optional<FarthestBlock> farthest_block(const Model& model, const State& state, const Vec2& reference);

}  // namespace rockslope::dda
