#pragma once

#include "blockgen/mesh/block_mesh.hpp"
#include "common/base/thread_pool.hpp"

namespace rockslope::blockgen {

/// Checks that a mesh is valid for simulation: each ring is simple, outer rings are counter-clockwise with
/// positive area, holes are clockwise and inside the outer ring, indices are in range, measured points and
/// bolt ends lie inside their blocks, bolts have a positive length, names of measured points are unique.
/// @throws InputError naming `file_name`, the block and the fault.
void check_mesh(const BlockMesh& mesh, const std::string& file_name, const ThreadPool& pool = ThreadPool());

}  // namespace rockslope::blockgen
