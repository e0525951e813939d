#pragma once

#include <string>
#include <string_view>

namespace rockslope {

/// The SHA-256 digest of the bytes (FIPS 180-4) in lower-case hexadecimal, as sha256sum prints it.
std::string sha256(std::string_view bytes);

}  // namespace rockslope
