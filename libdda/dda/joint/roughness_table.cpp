#include "dda/joint/roughness_table.hpp"

#include <algorithm>
#include <limits>

namespace rockslope::dda {

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

double RoughnessTable::next_below(double x) const {
    double nearest = -std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries)
        if (entry.x < x) nearest = entry.x;
    return nearest;
}

RoughnessTable barton_1985() {
    return {{{0, 0}, {0.3, 0}, {0.6, 0.75}, {1, 1}, {2, 0.85}, {4, 0.7}, {10, 0.5}, {100, 0}}};
}

}  // namespace rockslope::dda
