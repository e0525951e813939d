#pragma once

#include <optional>
#include <string>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A block that does not come to rest, and the joint that it moves along.
struct MovingBlock {
    BlockIndex block;
    double displacement = 0;    ///< m, of the centroid, in the stage
    double unbalanced = 0;      ///< unbalanced force over the weight
    std::optional<Contact> on;  ///< the sliding contact with the largest slip; none in free fall
};

/// The block whose centroid has moved farthest. @return none if no block has moved farther than `limit`, m.
std::optional<MovingBlock> block_moved_beyond(const Model& model, const State& state, double limit);

/// The block with the largest unbalanced force. @return none without free blocks.
std::optional<MovingBlock> least_balanced_block(const Model& model, const State& state);

/// One line: block, place, displacement, joint and unbalanced force.
std::string describe(const Model& model, const State& state, const MovingBlock& moving);

}  // namespace rockslope::dda
