#pragma once

#include <filesystem>
#include <string_view>

namespace rockslope {

/// Writes a whole file: to a temporary file in the same folder, then fsync and rename. A reader, or Make,
/// never sees a partial file, and an existing file survives a failure. The bytes are exactly `content`. A
/// path that exists and is not a regular file (a terminal, a pipe, a device) is written to directly.
/// @throws OutputError with the path and the system's reason (not writable, disk full, no such directory).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace rockslope
