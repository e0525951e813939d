#pragma once

#include <string>

namespace rockslope {

/// Base64 of the bytes (RFC 4648).
std::string base64(const std::string& bytes);

}  // namespace rockslope
