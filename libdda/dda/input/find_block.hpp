#pragma once

#include <optional>

#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The block whose rock holds a point of the initial configuration: the one that holds it inside, else one
/// whose face passes within a 1e-9th of the model's size; nothing for a point in the air.
std::optional<int> find_block(const Model& model, const Vec2& point);

}  // namespace rockslope::dda
