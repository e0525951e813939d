#pragma once

#include <string>
#include <string_view>

namespace rockslope::blockgen {

/// True when `text` is well-formed UTF-8: no overlong form, no surrogate, nothing above U+10FFFF.
bool is_utf8(std::string_view text);

/// A name as written in the block file. It is unquoted when it is not empty and has no blank, quote,
/// backslash, `#` or control character. Otherwise it is in double quotes, with the escapes `\"`, `\\`, `\n`,
/// `\r`, `\t` and `\xHH`.
std::string quoted_name(std::string_view name);

}  // namespace rockslope::blockgen
