#include "dda/joint/roughness_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/base/text.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

namespace {

/// Barton's curve: displacements over peak displacement, and the mobilised ratios there.
constexpr std::array<double, 7> barton_displacements = {0.3, 0.6, 1, 2, 4, 10, 100};
constexpr std::array<double, 7> barton_ratios = {0, 0.75, 1, 0.85, 0.7, 0.5, 0};

}  // namespace

/// The mobilised ratio, Eq. (59).
double RoughnessTable::ratio(double x) const {
    const auto above = std::upper_bound(entries.begin(), entries.end(), x,
                                        [](double value, const Entry& entry) { return value < entry.x; });
    if (above == entries.begin()) return entries.front().ratio;
    const Entry& below = *(above - 1);
    if (above == entries.end() || below.x == x) return below.ratio;
    return below.ratio + (above->ratio - below.ratio) * ((x - below.x) / (above->x - below.x));
}

double RoughnessTable::next_above(double x) const {
    for (const Entry& entry : entries)
        if (entry.x > x) return entry.x;
    return std::numeric_limits<double>::infinity();
}

RoughnessTable RoughnessTable::read(const ParameterTable& table, std::string_view key) {
    RoughnessTable roughness;
    const auto refuse = [&](const std::string& what, const std::string& expected) {
        table.fail(key, "'" + std::string(key) + "' in [" + table.path() + "] " + what, expected);
    };
    for (const auto& [x, ratio] : table.pairs(key)) {
        const std::string where = "has the entry [" + shortest_text(x) + ", " + shortest_text(ratio) + "]";
        if (x < 0 || (!roughness.entries.empty() && x <= roughness.entries.back().x))
            refuse(where, "displacements over peak displacement that start at 0 or above and grow");
        if (std::abs(ratio) > 1) refuse(where, "a mobilised ratio from -1 to 1");
        roughness.entries.push_back({x, ratio});
    }
    if (roughness.entries.empty()) refuse("is empty", "at least one pair [x, ratio]");
    return roughness;
}

RoughnessTable barton_1985() {
    RoughnessTable table{{{0, 0}}};
    for (std::size_t k = 0; k < barton_displacements.size(); ++k)
        table.entries.push_back({barton_displacements[k], barton_ratios[k]});
    return table;
}

}  // namespace rockslope::dda
