#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "blockgen/mesh/block_mesh.hpp"
#include "common/base/thread_pool.hpp"

namespace rockslope::blockgen {

/// The newest version of the block file that this code reads. The writer uses the lowest version that can
/// store the mesh: 3 with a water table, otherwise 2 with excavations and 1 without.
inline constexpr int block_file_version = 3;

/// The text of a block file. Numbers are written in the shortest form that reads back to the same double, so
/// that writing, reading and writing again gives the same bytes.
std::string block_file_text(const BlockMesh& mesh);

/// Parses the text of a block file. @throws InputError with file and line when the file is truncated or of a
/// newer version, an index is out of range, a number is not finite, or a record is otherwise malformed.
BlockMesh parse_block_file(std::string_view text, const std::string& file_name);

/// As parse_block_file(), of a file.
BlockMesh read_block_file(const std::filesystem::path& path);
/// Writes the block file of a mesh, piece by piece. The bytes do not depend on the number of threads.
void write_block_file(const std::filesystem::path& path, const BlockMesh& mesh,
                      const ThreadPool& pool = ThreadPool());

}  // namespace rockslope::blockgen
