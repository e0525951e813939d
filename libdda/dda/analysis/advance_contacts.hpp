#pragma once

#include <span>

#include "dda/analysis/step_problem.hpp"

namespace rockslope::dda {

/// Takes the contacts of an accepted step to its end: geometry, state, forces, slip, and what their joints
/// have been through.
/// @param segments of the contacts; @param vertices at the step's end; @param evaluated per contact; @param
/// springs of the step; @param duration s, 0 where a step is no time.
void advance_contacts(const Model& model, const JointSegments& segments, std::span<const Vec2> vertices,
                      std::span<const EvaluatedContact> evaluated, std::span<const ContactSprings> springs,
                      double duration, const ThreadPool& pool, std::span<Contact> contacts);

}  // namespace rockslope::dda
