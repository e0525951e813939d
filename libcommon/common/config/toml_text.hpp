#pragma once

#include <string>
#include <string_view>

namespace rockslope {

/// A TOML string literal of `text`.
std::string toml_string(std::string_view text);

}  // namespace rockslope
