#pragma once

#include <cctype>
#include <cstdio>
#include <string>

namespace rockslope {

/// Name of a case of a parametrised test, of the letters, digits and underscores that GoogleTest accepts:
/// "w_dt 0.05" becomes "w_dt_0_05".
inline std::string case_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        const bool keep = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (keep || (!name.empty() && name.back() != '_')) name += keep ? c : '_';
    }
    while (name.ends_with('_')) name.pop_back();
    return name;
}

/// A number as text for case_name(), of at most six digits.
inline std::string case_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

}  // namespace rockslope
