#pragma once

#include <cstdint>
#include <vector>

#include "dda/analysis/energy.hpp"
#include "dda/block/block_system.hpp"
#include "dda/contact/contact.hpp"
#include "dda/terms/viscous_boundary.hpp"

namespace rockslope::dda {

/// Everything that changes during a run but the contacts, at one instant.
struct StateWithoutContacts {
    double time = 0;               ///< s since the start of the run
    double stage_time = 0;         ///< s since the start of the stage
    double dynamic_time = 0;       ///< s of the run's dynamic stages so far: the clock of load histories
    double next_step = 0;          ///< s, the step to try next; 0: the stage's own
    std::int64_t step_count = 0;   ///< since the start of the run
    std::int64_t stage_steps = 0;  ///< since the start of the stage
    BlockSystem blocks;
    std::vector<Vec2> displacement_origin;  ///< per material point: where displacements count from, m
    std::vector<Vec2> centroid_origin;      ///< per block: likewise
    std::vector<double> bolt_force;         ///< per bolt, N per metre, tension positive
    BoundaryReactions boundary_reactions;   ///< of viscous boundaries, N per metre
    FreeFieldMotions free_fields;           ///< beside viscous boundaries
    Energy energy;
    std::vector<std::uint8_t> removed;  ///< per block, 1 where it was taken out; empty while all are there

    bool is_present(int block) const {
        return removed.empty() || removed[static_cast<std::size_t>(block)] == 0;
    }
};

/// Everything that changes during a run, at one instant. A trial step makes a new one; a rejected step
/// forgets it.
struct State : StateWithoutContacts {
    ContactSet contacts;
};

}  // namespace rockslope::dda
