#pragma once

#include <span>

#include "common/base/thread_pool.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/contact/joint_segments.hpp"
#include "dda/contact/search_radius.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Input of the contact search of a step.
struct ContactSearch {
    CornerSpan<const Vec2> vertices;           ///< per corner, at the start of the step, m
    CornerSpan<const Vec2> mid_step_vertices;  ///< per corner, predicted at mid-step, m
    std::span<const CornerEdge> forced;        ///< see DetectionInput
    SearchRadius search_radius;                ///< within which a pair may meet in the step
    double edge_length = 0;                    ///< m, median of the model
    double depth_tolerance = 0;                ///< m, see DetectionInput
    double duration = 0;                       ///< s, of the step; 0 in static stages
    bool first_step = false;                   ///< of the run: faces that touch are unbroken joints
};

struct FoundContacts {
    ContactSet set;
    JointSegments segments;  ///< of the contacts in `set`
};

/// The contacts of a step: candidates (the last list is kept while it is complete, Eq. (26)), detection,
/// transfer of state from `last`, and the normal forces at the start of the step.
/// @param last the contacts at the end of the last step, at `search.vertices`.
FoundContacts find_contacts(const Model& model, const ContactSet& last, const ContactSearch& search,
                            const ThreadPool& pool, PhaseTimes* times = nullptr);

}  // namespace rockslope::dda
