#include "picture_style.hpp"

#include <utility>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"

namespace rockslope {

double page_length(const std::string& text) {
    constexpr double narrowest = 100, widest = 5000;
    constexpr std::pair<const char*, double> units[] = {
        {"mm", 72 / 25.4}, {"cm", 720 / 25.4}, {"in", 72}, {"pt", 1}};
    for (const auto& [unit, points] : units) {
        if (!text.ends_with(unit)) continue;
        const auto number = parse_number(std::string_view(text).substr(0, text.size() - 2));
        if (number && *number * points >= narrowest && *number * points <= widest) return *number * points;
    }
    throw InputError({"dda-plot"}, "--width is '" + text + "'",
                     "a length from 36mm to 1.7m with its unit: mm, cm, in or pt, such as 85mm");
}

}  // namespace rockslope
