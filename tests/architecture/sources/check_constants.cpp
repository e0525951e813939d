#include <cstdlib>
#include <map>

#include "checks.hpp"

namespace rockslope::sources {

namespace {

struct Place {
    std::string path;
    std::string value;
};
/// The places of each constant, by "program name" or, in the libraries, " name".
using Constants = std::map<std::string, std::vector<Place>>;

/// "dda-run" of "tools/dda-run/...", nothing for a library.
std::string program_of(const std::string& path) {
    if (!path.starts_with("tools/")) return "";
    return path.substr(6, path.find('/', 6) - 6);
}

/// A value in a form that is the same for equal numbers: "1000" for 1'000 and for 1e3. Empty for a text or a
/// value that has a name in it.
std::string number_in(std::string value) {
    std::erase(value, '\'');
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (end != value.c_str() && *end == '\0') return std::to_string(number * 1e12);
    const bool is_sum = value.find_first_not_of("0123456789.e+-*/<>()") == std::string::npos;
    return is_sum ? value : "";
}

/// Adds the variables "a = 1, b = 2" of one `constexpr` declaration; `k` is the token of `constexpr`.
void add_declaration(const SourceFile& file, std::size_t k, Constants& constants) {
    const std::vector<Token>& all = file.tokens.all;
    std::string name, value;
    bool in_value = false;
    int depth = 0;
    for (; k < all.size(); ++k) {
        const std::string& text = all[k].text;
        depth += text == "(" || text == "{" || text == "[" ? 1 : 0;
        depth -= text == ")" || text == "}" || text == "]" ? 1 : 0;
        if (depth < 0 || (depth > 0 && !in_value)) return;  // a function or a condition
        if (depth == 0 && (text == "," || text == ";")) {
            if (!number_in(value).empty())
                constants[program_of(file.path) + " " + name].push_back({file.path, value});
            if (text == ";") return;
            value.clear();
            in_value = false;
        } else if (in_value) {
            value += text;
        } else if (text == "=") {
            in_value = true;
        } else if (all[k].kind == Token::Kind::name) {
            name = text;
        }
    }
}

/// The constants of a file, but for the members of its classes, which have the name of their class before
/// their own.
void add_constants(const SourceFile& file, Constants& constants) {
    const std::vector<Token>& all = file.tokens.all;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool is_member = k > 0 && all[k - 1].text == "static";
        if (all[k].text == "constexpr" && !is_member) add_declaration(file, k, constants);
    }
}

}  // namespace

Faults check_constants(const std::vector<SourceFile>& files) {
    Constants constants;
    for (const SourceFile& file : files)
        if (file.is_in_library() || file.path.starts_with("tools/")) add_constants(file, constants);
    Faults faults;
    for (const auto& [key, places] : constants) {
        for (const Place& place : places) {
            if (number_in(place.value) == number_in(places[0].value)) continue;
            faults.push_back(key.substr(key.find(' ') + 1) + " is " + places[0].value + " in " +
                             places[0].path + " and " + place.value + " in " + place.path);
        }
    }
    return faults;
}

}  // namespace rockslope::sources
