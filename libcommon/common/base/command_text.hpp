#pragma once

#include <filesystem>
#include <string>

namespace rockslope {

/// A path as a target or a prerequisite of a Make rule.
std::string make_escaped(const std::filesystem::path& path);

}  // namespace rockslope
