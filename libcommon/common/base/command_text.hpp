#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rockslope {

/// A path as a target or a prerequisite of a Make rule.
std::string make_escaped(const std::filesystem::path& path);

/// A word of a shell command, in single quotes unless it needs none.
std::string shell_quoted(std::string_view word);

/// A shell command as a line of a Make recipe: each dollar sign is doubled.
std::string recipe_text(std::string_view command);

}  // namespace rockslope
