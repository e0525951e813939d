#pragma once

#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// Warnings of sides of the section that nothing holds, with their lengths, and of held blocks that are tiny.
/// A side is the rim along the left, the right or the lower side of the domain's bounding box. Only for a
/// section with fixed or prescribed blocks.
std::vector<std::string> boundary_warnings(const BlockMesh& mesh, const SlopeModel& model);

/// Warnings of regions whose outlines part no blocks although the model seems to ask for it: a region with a
/// joint_material and the block material of its surroundings, and a Voronoi set in such a region.
std::vector<std::string> region_warnings(const CutContext& cut);

}  // namespace rockslope::blockgen
