#include "blockgen/input/length_unit.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace rockslope::blockgen {

namespace {

struct LengthUnit {
    const char* name;
    double metres;
};

constexpr std::array<LengthUnit, 10> length_units = {{{"mm", 1e-3},
                                                      {"cm", 1e-2},
                                                      {"dm", 1e-1},
                                                      {"m", 1},
                                                      {"km", 1e3},
                                                      {"in", 0.0254},
                                                      {"ft", 0.3048},
                                                      {"us-ft", 1200.0 / 3937},
                                                      {"yd", 0.9144},
                                                      {"mi", 1609.344}}};

struct Synonym {
    const char* stated;
    const char* word;
};

/// Names of units in the vertical systems of EPSG and in elevation models, in lower case.
constexpr std::array<Synonym, 16> synonyms = {{{"metre", "m"},
                                               {"meter", "m"},
                                               {"metres", "m"},
                                               {"meters", "m"},
                                               {"centimetre", "cm"},
                                               {"centimeter", "cm"},
                                               {"millimetre", "mm"},
                                               {"millimeter", "mm"},
                                               {"foot", "ft"},
                                               {"feet", "ft"},
                                               {"international foot", "ft"},
                                               {"us survey foot", "us-ft"},
                                               {"us survey feet", "us-ft"},
                                               {"us_survey_foot", "us-ft"},
                                               {"foot_us", "us-ft"},
                                               {"ftus", "us-ft"}}};

}  // namespace

std::optional<double> metres_in(std::string_view unit) {
    for (const LengthUnit& known : length_units)
        if (unit == known.name) return known.metres;
    return std::nullopt;
}

std::string length_unit_word(const std::string& stated) {
    std::string lower = stated;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Synonym& synonym : synonyms)
        if (lower == synonym.stated) return synonym.word;
    return metres_in(lower) ? lower : stated;
}

std::string length_unit_words() {
    std::string names;
    for (const LengthUnit& unit : length_units) names += (names.empty() ? "" : ", ") + std::string(unit.name);
    return names;
}

}  // namespace rockslope::blockgen
