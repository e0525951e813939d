#pragma once

#include <span>

#include "common/base/thread_pool.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/contact/joint_segments.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// What the contacts of a step are found from.
struct ContactSearch {
    std::span<const Vec2> vertices;           ///< per corner, at the step's start, m
    std::span<const Vec2> mid_step_vertices;  ///< where they are expected half-way through the step
    std::span<const CornerEdge> forced;       ///< see DetectionInput
    double search_radius = 0;                 ///< m, within which a corner and an edge may meet in the step
    double edge_length = 0;                   ///< m, median
    double depth_tolerance = 0;               ///< m, depth that means nothing
    double duration = 0;                      ///< s of the step; 0 where steps are no time
    bool first_step = false;
};

struct FoundContacts {
    ContactSet set;
    JointSegments segments;  ///< of its contacts
};

/// The contacts of a step: candidates from the last search while those are complete (theory, Eq. (26)),
/// detection, transfer of what `last` carried, and the forces that follow from the geometry.
/// @param last the contacts at the end of the step before, at `search.vertices`.
FoundContacts find_contacts(const Model& model, const ContactSet& last, const ContactSearch& search,
                            const ThreadPool& pool, PhaseTimes* times = nullptr);

}  // namespace rockslope::dda
