#pragma once

#include <span>

#include "dda/analysis/step_problem.hpp"

namespace dda {

/// Takes the contacts of an accepted step to its end: geometry, state, forces, slip, the joint's history.
/// @param vertices at the step's end; @param judged per contact.
void advance_contacts(const Model& model, std::span<const Vec2> vertices,
                      std::span<const JudgedContact> judged, std::span<Contact> contacts);

}  // namespace dda
