#pragma once

#include <string>
#include <string_view>

namespace rockslope::blockgen {

/// True when `text` is well-formed UTF-8: no overlong form, no surrogate, nothing above U+10FFFF.
bool is_utf8(std::string_view text);

/// A name as the block file spells it: bare when it has no blank, quote, backslash, `#` or control character
/// and is not empty; otherwise between double quotes, with the escapes `\"`, `\\`, `\n`, `\r`, `\t` and
/// `\xHH`.
std::string quoted_name(std::string_view name);

}  // namespace rockslope::blockgen
