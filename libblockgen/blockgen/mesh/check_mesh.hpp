#pragma once

#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// Proves a mesh fit for simulation: every ring simple, outer rings counter-clockwise with positive area,
/// holes clockwise and inside, indices in range, measured points and bolts inside their blocks,
/// bolts of some length, each measured point under a name of its own.
/// @throws InputError naming `file_name`, the block and the fault.
void check_mesh(const BlockMesh& mesh, const std::string& file_name);

}  // namespace rockslope::blockgen
