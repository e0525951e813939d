#include "common/base/command_text.hpp"

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

}  // namespace rockslope
