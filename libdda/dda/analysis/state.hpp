#pragma once

#include <cstdint>
#include <vector>

#include "dda/analysis/energy.hpp"
#include "dda/block/block_system.hpp"
#include "dda/contact/contact.hpp"
#include "dda/terms/viscous_boundary.hpp"

namespace rockslope::dda {

/// Bonds that could not be held at rest.
struct BrokenBonds {
    std::int64_t contacts = 0;  ///< whose bonds broke
    std::int64_t events = 0;    ///< in which they broke, the worst first
};

/// Bonds that are held at rest, see strained_bonds().
struct StrainedBonds {
    std::int64_t contacts = 0;  ///< whose bonds bear all of their strength
    std::int64_t of = 0;        ///< contacts with a bond
};

/// A block that has left the model's ground, see note_lost_blocks().
struct LostBlock {
    BlockIndex block;
    double time = 0;               ///< s since the start of the run
    Vec2 centroid = Vec2::Zero();  ///< m, at that time
};

/// A contact that penetrates, see note_deepest_contact().
struct DeepestContact {
    double share = 0;  ///< of the penetration in the smaller block's size
    double depth = 0;  ///< m
    double time = 0;   ///< s since the start of the run
    BlockIndex corner_block = BlockIndex::none();
    BlockIndex edge_block = BlockIndex::none();
};

/// The state of the model at one instant, without its contacts.
struct StateWithoutContacts {
    double time = 0;               ///< s since the start of the run
    double stage_time = 0;         ///< s since the start of the stage
    double dynamic_time = 0;       ///< s, sum over the dynamic stages so far: the time of load histories
    double next_step = 0;          ///< s, size of the next trial step; 0: the stage's step
    std::int64_t step_count = 0;   ///< since the start of the run
    std::int64_t stage_steps = 0;  ///< since the start of the stage
    std::int64_t short_steps = 0;  ///< the last steps in a row that were far below the stage's step
    BlockSystem blocks;
    PerPoint<Vec2> displacement_origin;    ///< m, per material point: position of zero displacement
    PerBlock<Vec2> centroid_origin;        ///< m, per block: centroid of zero displacement
    PerCorner<Vec2> vertex_origin;         ///< m, per corner: position of zero displacement
    PerBlock<Vec2> stage_origin;           ///< m, per block: centroid at the stage's start
    std::vector<double> bolt_force;        ///< per bolt that is not removed, N per metre, tension positive
    BoundaryReactions boundary_reactions;  ///< of viscous boundaries, N per metre
    FreeFieldMotions free_fields;          ///< of the columns beside viscous boundaries
    Energy energy;
    BrokenBonds broken_bonds;            ///< of static stages whose bonds break at rest
    StrainedBonds strained_bonds;        ///< at the end of such a stage; none from the next stage on
    std::vector<LostBlock> lost_blocks;  ///< in the order in which they left the ground
    DeepestContact deepest_contact;      ///< so far
    PerBlock<std::uint8_t> removed;      ///< per block, 1 if excavated; empty as long as no block is

    bool is_present(BlockIndex block) const { return removed.empty() || removed[block] == 0; }
};

/// The state of the model at one instant. A trial step computes a new one; a rejected step discards it.
struct State : StateWithoutContacts {
    ContactSet contacts;
};

}  // namespace rockslope::dda
