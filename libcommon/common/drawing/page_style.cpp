#include "common/drawing/page_style.hpp"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"

namespace rockslope {

namespace {

/// Widest page, pt, largest letters, pt, and the least room across a page, units.
constexpr double widest = 5000, largest_font = 72, least_room = 150;

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;

/// Names that stand for whatever font of their kind is installed.
bool is_generic(const std::string& family) {
    constexpr std::array<std::string_view, 7> names = {"sans-serif", "sans",    "serif",    "monospace",
                                                       "cursive",    "fantasy", "system-ui"};
    return std::find(names.begin(), names.end(), family) != names.end();
}

/// The font that fontconfig chooses for a family; nothing when there is none at all.
Pattern match_of(const std::string& family) {
    const Pattern wanted(FcPatternCreate(), FcPatternDestroy);
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    return {FcFontMatch(nullptr, wanted.get(), &result), FcPatternDestroy};
}

/// The names of a font, the most usual one first: it may have one in each of several languages.
std::vector<std::string> families_of(const Pattern& font) {
    std::vector<std::string> names;
    FcChar8* name = nullptr;
    for (int k = 0; font && FcPatternGetString(font.get(), FC_FAMILY, k, &name) == FcResultMatch; ++k)
        names.emplace_back(reinterpret_cast<const char*>(name));
    return names;
}

bool same_letters(const std::string& one, const std::string& other) {
    return FcStrCmpIgnoreCase(reinterpret_cast<const FcChar8*>(one.c_str()),
                              reinterpret_cast<const FcChar8*>(other.c_str())) == 0;
}

/// The font of a request. @throws InputError for one that is not installed.
std::string checked_font(const std::string& family, const std::string& program) {
    const std::vector<std::string> found = families_of(match_of(family));
    const bool is_installed = std::any_of(
        found.begin(), found.end(), [&](const std::string& name) { return same_letters(name, family); });
    if (is_installed || (is_generic(family) && !found.empty())) return family;
    const std::string instead = found.empty() ? "" : "; '" + found.front() + "' would be drawn";
    throw InputError({program}, "--font is '" + family + "', which is not installed" + instead,
                     "a font that fc-list names");
}

/// A length with its unit, pt.
std::optional<double> length_of(const std::string& text) {
    constexpr std::pair<std::string_view, double> units[] = {
        {"mm", 72 / 25.4}, {"cm", 720 / 25.4}, {"in", 72}, {"pt", 1}};
    for (const auto& [unit, points] : units) {
        if (!text.ends_with(unit)) continue;
        const auto number = parse_number(std::string_view(text).substr(0, text.size() - unit.size()));
        if (number) return *number * points;
    }
    return std::nullopt;
}

double checked_width(const std::string& text, double unit, const std::string& program) {
    const double narrowest = least_room * unit;
    const std::optional<double> width = length_of(text);
    if (width && *width >= narrowest && *width <= widest) return *width;
    const auto millimetres = static_cast<int>(std::ceil(narrowest * 25.4 / 72));
    throw InputError(
        {program}, "--width is '" + text + "'",
        "a length from " + std::to_string(millimetres) +
            "mm, for letters of this size, to 1.7m with its unit: mm, cm, in or pt, such as 85mm");
}

}  // namespace

PageStyle page_style(const PageRequest& request, const std::string& program) {
    PageStyle style;
    const double size = request.font_size.value_or(usual_font_size);
    if (!(size > 0 && size <= largest_font))
        throw InputError({program}, "--font-size is " + shortest_text(size), "a size up to 72 pt");
    style.unit = size / usual_font_size;
    if (request.width) style.width = checked_width(*request.width, style.unit, program);
    if (request.font) style.family = checked_font(*request.font, program);
    return style;
}

}  // namespace rockslope
