#pragma once

#include <string>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The block that holds a point, its edges included; the first of several; -1 when none does.
std::int32_t block_at(const BlockMesh& mesh, const Point& p);

/// Fixes and prescribes blocks and places measured points and bolts, as the model says. A fixed or prescribed
/// block whose point lies outside the rock is the nearest one, with a warning, up to a twentieth of the
/// domain's size away.
/// @throws InputError for a point that no block holds, or a block chosen twice in contradiction.
void apply_block_selectors(BlockMesh& mesh, const SlopeModel& model, std::vector<std::string>& warnings);

}  // namespace rockslope::blockgen
