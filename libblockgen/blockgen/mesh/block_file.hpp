#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The newest version of the block file that this code reads. A file is written in the lowest version that
/// holds it: 1 without excavations, 2 with them.
inline constexpr int block_file_version = 2;

/// The text of a block file; numbers are written shortest-round-trip, so write, read, write gives the same
/// bytes.
std::string block_file_text(const BlockMesh& mesh);

/// Parses the text of a block file. @throws InputError with file:line for anything that is not a whole,
/// consistent file of a version this code knows: truncation, a newer version, an index out of range, a number
/// that is not finite.
BlockMesh parse_block_file(std::string_view text, const std::string& file_name);

BlockMesh read_block_file(const std::filesystem::path& path);
void write_block_file(const std::filesystem::path& path, const BlockMesh& mesh);

}  // namespace rockslope::blockgen
