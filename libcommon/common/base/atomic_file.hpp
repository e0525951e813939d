#pragma once

#include <filesystem>
#include <string_view>

namespace rockslope {

/// Writes a whole file by way of a temporary name beside it, fsync and rename, so that a reader, or Make,
/// never sees half of it and an existing file survives a failure. The bytes are exactly `content`. A path
/// that exists and is no regular file (a terminal, a pipe, a device) is written to as it is.
/// @throws OutputError naming the path and the system's reason (not writable, disk full, no such directory).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace rockslope
