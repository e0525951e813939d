#pragma once

#include <string>
#include <vector>

#include "dda/analysis/energy.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A run tells of friction that returned more than this fraction of what it took, and of springs or an
/// integration that gave more than this fraction of the energy turned over.
inline constexpr double returned_share_told = 1e-3;
/// A dynamic stage ends above this fraction of the energy turned over.
inline constexpr double returned_share_allowed = 0.1;

/// The energy that a run has turned over so far, J per metre: the kinetic energy and all that was lost; or
/// the energy that springs and strained blocks store, where that is more.
double turned_over(const Energy& energy);

/// Whether a run tells of what friction returned.
bool returns_friction(const Energy& energy);

/// One line each on energy that came from nowhere so far: what friction returned, what springs gained while
/// they were replaced, and what the time integration gave, with the contact and the step that gave most.
std::vector<std::string> energy_from_nowhere(const Model& model, const Energy& energy);

/// Whether a run must not go on: friction, which only takes energy, returned too much.
bool creates_energy(const Energy& energy);

/// One line: how much friction returned, and the contact that gave most in one step.
std::string describe_returned(const Model& model, const Energy& energy);

}  // namespace rockslope::dda
