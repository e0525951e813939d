#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace rockslope {

/// The text that std::snprintf writes, at most 199 characters.
template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 200> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

}  // namespace rockslope
