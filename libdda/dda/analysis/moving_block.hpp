#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// A block that does not come to rest, and what holds it.
struct MovingBlock {
    BlockIndex block;
    double displacement = 0;          ///< m, of the centroid, in the stage
    double unbalanced = 0;            ///< unbalanced force over the weight
    std::optional<Contact> on;        ///< the sliding contact with the largest slip
    std::optional<Contact> against;   ///< a closed contact that does not slide
    bool falls_freely = false;        ///< its acceleration is that of gravity alone
    const char* pushed_by = nullptr;  ///< key of the load that moves it on; null: no load does
};

/// The free blocks whose unbalanced force over the weight is above `tolerance`.
std::vector<BlockIndex> moving_blocks(const Model& model, const State& state, double tolerance);

/// The mass of some blocks over that of all free blocks; 0 without free blocks.
double share_of_mass(const Model& model, const State& state, std::span<const BlockIndex> blocks);

/// Whether a static stage has come to rest: the blocks that move are at most the stage's `moving_share`.
bool is_at_rest(const Model& model, const State& state, const Stage& stage);

/// The heaviest block whose centroid has moved farther than `limit`, m, where such blocks are more than
/// `share` of the mass of all free blocks; of equal ones that which has moved farthest. Blocks that still
/// move come first: their unbalanced force over the weight is above `tolerance`.
std::optional<MovingBlock> block_moved_beyond(const Model& model, const State& state, double limit,
                                              double share, double tolerance);

/// A moving block, described.
MovingBlock moving_block(const Model& model, const State& state, BlockIndex block);

/// The block with the largest unbalanced force. @return none without free blocks.
std::optional<MovingBlock> least_balanced_block(const Model& model, const State& state);

/// How a block moves: along a joint, against another block, in free fall, or under its loads alone; and which
/// load pushes it.
std::string describe_manner(const Model& model, const MovingBlock& moving);

/// One line: block, place, displacement, what it moves along or is held by, and unbalanced force.
/// @param tolerance unbalanced force over the weight, up to which the block lies still.
std::string describe(const Model& model, const State& state, const MovingBlock& moving, double tolerance);

}  // namespace rockslope::dda
