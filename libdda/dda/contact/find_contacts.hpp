#pragma once

#include <span>

#include "dda/base/parallel.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/contact/joint_faces.hpp"
#include "dda/model/model.hpp"

namespace dda {

/// What the contacts of a step are found from.
struct ContactSearch {
    std::span<const Vec2> vertices;        ///< per corner, at the step's start, m
    std::span<const Vec2> half_way;        ///< where they are expected half-way through the step
    std::span<const CornerEdge> entering;  ///< see Detection
    double reach = 0;                      ///< m, within which a corner and an edge may meet in the step
    double edge_length = 0;                ///< m, median
    double rounding = 0;                   ///< m, depth that means nothing
    double duration = 0;                   ///< s of the step; 0 where steps are no time
    bool first_step = false;
};

struct FoundContacts {
    ContactSet set;
    JointFaces faces;  ///< of its contacts
};

/// The contacts of a step: candidates from the last search while those are complete (theory, Eq. (26)),
/// detection, transfer of what `last` carried, and the forces that follow from the geometry.
/// @param last the contacts at the end of the step before, at `search.vertices`.
FoundContacts find_contacts(const Model& model, const ContactSet& last, const ContactSearch& search,
                            const Crew& crew, PhaseTimes* times = nullptr);

}  // namespace dda
