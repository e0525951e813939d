#include "common/base/command_text.hpp"

#include <algorithm>

namespace rockslope {

std::string make_escaped(const std::filesystem::path& path) {
    std::string text;
    for (const char c : path.string()) {
        if (c == ' ' || c == '#' || c == '\\') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

std::string shell_quoted(std::string_view word) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("_-+=./,:@%").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return std::string(word);
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string recipe_text(std::string_view command) {
    std::string text;
    for (const char c : command) text += c == '$' ? std::string("$$") : std::string(1, c);
    return text;
}

}  // namespace rockslope
