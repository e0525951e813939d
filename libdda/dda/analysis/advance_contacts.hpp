#pragma once

#include <span>

#include "dda/analysis/step_problem.hpp"

namespace dda {

/// Takes the contacts of an accepted step to its end: geometry, state, forces, slip, and what their joints
/// have been through.
/// @param faces of the contacts; @param vertices at the step's end; @param judged per contact; @param springs
/// of the step; @param duration s, 0 where a step is no time.
void advance_contacts(const Model& model, const JointFaces& faces, std::span<const Vec2> vertices,
                      std::span<const JudgedContact> judged, std::span<const ContactSprings> springs,
                      double duration, const Crew& crew, std::span<Contact> contacts);

}  // namespace dda
