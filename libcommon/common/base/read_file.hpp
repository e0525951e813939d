#pragma once

#include <filesystem>
#include <string>

namespace rockslope {

/// The bytes of a whole file; a ReadLog of this thread notes it.
/// @throws InputError with the path and the system's reason (missing, a folder, no permission), or when there
/// is more than 4 GiB, or more than 256 MiB in a pipe or a device.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace rockslope
