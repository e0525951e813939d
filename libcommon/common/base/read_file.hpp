#pragma once

#include <filesystem>
#include <string>

namespace rockslope {

/// The bytes of a whole file; a ReadLog of this thread notes it.
/// @throws InputError with the path and the system's reason (missing, a folder, no permission).
std::string read_text_file(const std::filesystem::path& path);

}  // namespace rockslope
