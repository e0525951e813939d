#pragma once

#include <charconv>
#include <map>
#include <stdexcept>
#include <string>

namespace rockslope::bench {

/// By name with its dashes; a flag's value is "yes".
using Options = std::map<std::string, std::string>;

/// @param options the defaults. @throws std::invalid_argument for what is no option with a value.
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

/// @throws std::invalid_argument for what is not a number or is below the least.
template <class Number>
Number read_number(const std::string& text, Number least) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= least))
        throw std::invalid_argument(text);
    return value;
}

/// COLUMNSxROWS. @throws std::invalid_argument
struct WallSize {
    int columns = 0;
    int rows = 0;
};

inline WallSize read_wall_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) throw std::invalid_argument(text);
    return {read_number(text.substr(0, cross), 1), read_number(text.substr(cross + 1), 1)};
}

}  // namespace rockslope::bench
