#include "common/base/input_error.hpp"

#include <algorithm>

namespace rockslope {

namespace {

/// A part of a message with its middle left out where it is longer than can be read.
std::string shortened(const std::string& text) {
    constexpr std::size_t longest_part = 2000;
    constexpr std::size_t kept = 600;  // at each end
    if (text.size() <= longest_part) return text;
    return text.substr(0, kept) + " ... " + text.substr(text.size() - kept);
}

std::string one_line(const SourceLocation& place, const std::string& what, const std::string& expected) {
    std::string text = shortened(place.text());
    if (!text.empty()) text += ": ";
    text += shortened(what);
    if (!expected.empty()) text += "; expected " + shortened(expected);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        ' ');
    return text;
}

}  // namespace

std::string SourceLocation::text() const {
    std::string result = file;
    if (line > 0) {
        result += ':' + std::to_string(line);
        if (column > 0) result += ':' + std::to_string(column);
    }
    return result;
}

InputError::InputError(const SourceLocation& place, const std::string& what, const std::string& expected)
    : std::runtime_error(one_line(place, what, expected)), place_(place) {}

}  // namespace rockslope
