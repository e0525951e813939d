#include "blockgen/mesh/names.hpp"

#include <algorithm>

namespace rockslope::blockgen {

namespace {

bool is_unquoted_character(unsigned char c) {
    return c > 0x20 && c != 0x7f && c != '"' && c != '\\' && c != '#';
}

bool is_continuation(std::string_view text, std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u;
}

/// The length of the well-formed sequence that starts at i, or 0.
std::size_t sequence_length(std::string_view text, std::size_t i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if (!is_continuation(text, i + k)) return 0;
    const auto second = static_cast<unsigned char>(text[i + 1]);
    const bool overlong = (lead == 0xe0 && second < 0xa0) || (lead == 0xf0 && second < 0x90);
    const bool surrogate = lead == 0xed && second > 0x9f;
    const bool too_large = lead == 0xf4 && second > 0x8f;
    return overlong || surrogate || too_large ? 0 : length;
}

void append_escaped(std::string& out, char c) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(c);
    switch (c) {
        case '"':
            out += "\\\"";
            return;
        case '\\':
            out += "\\\\";
            return;
        case '\n':
            out += "\\n";
            return;
        case '\r':
            out += "\\r";
            return;
        case '\t':
            out += "\\t";
            return;
        default:
            break;
    }
    if (code >= 0x20 && code != 0x7f) {
        out += c;
        return;
    }
    out += "\\x";
    out += digits[code >> 4u];
    out += digits[code & 0xfu];
}

}  // namespace

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = sequence_length(text, i);
        if (length == 0) return false;
        i += length;
    }
    return true;
}

std::string quoted_name(std::string_view name) {
    if (!name.empty() && std::all_of(name.begin(), name.end(), is_unquoted_character))
        return std::string(name);
    std::string out = "\"";
    for (const char c : name) append_escaped(out, c);
    return out + '"';
}

}  // namespace rockslope::blockgen
