#include "colour_scale.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope {

double area_weighted_quantile(std::vector<DisplacedArea> parts, double fraction) {
    std::sort(parts.begin(), parts.end(),
              [](const DisplacedArea& a, const DisplacedArea& b) { return a.distance < b.distance; });
    double total = 0;
    for (const DisplacedArea& part : parts) total += part.area;
    double covered = 0;
    for (const DisplacedArea& part : parts) {
        covered += part.area;
        if (covered >= fraction * total * (1 - 1e-12)) return part.distance;
    }
    return 0;
}

double round_length_above(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double factor : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (factor * power >= length * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

}  // namespace rockslope
