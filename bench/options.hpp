#pragma once

#include <charconv>
#include <map>
#include <stdexcept>
#include <string>

namespace rockslope::bench {

/// Values by option name with its dashes; the value of a flag is "yes".
using Options = std::map<std::string, std::string>;

/// @param options the defaults. @throws std::invalid_argument for an argument that is not an option with a
/// value.
inline Options read_options(int argc, char** argv, Options options) {
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--no-heading")
            options[name] = "yes";
        else if (name.rfind("--", 0) == 0 && i + 1 < argc)
            options[name] = argv[++i];
        else
            throw std::invalid_argument(name);
    }
    return options;
}

/// @throws std::invalid_argument for a text that is not a number or is below `minimum`.
template <class Number>
Number read_number(const std::string& text, Number minimum) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= minimum))
        throw std::invalid_argument(text);
    return value;
}

struct WallSize {
    int columns = 0;
    int rows = 0;
};

/// Reads COLUMNSxROWS. @throws std::invalid_argument
inline WallSize read_wall_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) throw std::invalid_argument(text);
    return {read_number(text.substr(0, cross), 1), read_number(text.substr(cross + 1), 1)};
}

}  // namespace rockslope::bench
