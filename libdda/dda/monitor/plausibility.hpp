#pragma once

#include <string>
#include <vector>

#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// What in a model is most likely a slip of the user, a sentence each: a stiffness or density that no rock
/// has, as where a unit is missing, a friction angle that no joint has or that rather is in radians, a
/// tensile strength beyond the end of the shear strength, blocks far too small for the section, chips among
/// large blocks, steps longer than those of the record, a record that the stage cuts short. The run is
/// possible all the same.
std::vector<std::string> implausible(const Model& model, const std::vector<Stage>& stages);

}  // namespace rockslope::dda
