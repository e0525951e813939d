#pragma once

#include <string>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The first block that contains a point, edges included; none when no block does.
BlockIndex block_at(const BlockMesh& mesh, const Point& p);

/// Applies the model's material lines, fixed and prescribed blocks, measured points and bolts to a mesh. A
/// fixed or prescribed block may be selected by a point outside the rock: the nearest block is used, with a
/// warning, up to a distance of 0.05 times the domain's diagonal.
/// @throws InputError for a point that no block contains, or a block with two different motions.
void apply_block_selectors(BlockMesh& mesh, const SlopeModel& model, std::vector<std::string>& warnings);

}  // namespace rockslope::blockgen
