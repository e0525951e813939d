#include "record/rotate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/base/degree.hpp"

namespace rockslope::record {

Accelerogram rotated(const HorizontalComponent& first, const HorizontalComponent& second, double azimuth) {
    const double step = first.record.step;
    if (!(std::abs(second.record.step - step) <= 1e-9 * step))
        throw std::invalid_argument("the two components have different steps");
    const double between = std::sin((second.azimuth - first.azimuth) * degree);
    if (!(std::abs(between) >= std::sin(10 * degree)) || !std::isfinite(azimuth))
        throw std::invalid_argument(
            "azimuths must be finite, and the components at least 10 degrees from parallel");
    // e(azimuth) = first_weight e(first) + second_weight e(second), so a . e is the same combination of a_i.
    const double first_weight = std::sin((second.azimuth - azimuth) * degree) / between;
    const double second_weight = std::sin((azimuth - first.azimuth) * degree) / between;
    Accelerogram result{step, {}};
    const std::size_t count = std::min(first.record.values.size(), second.record.values.size());
    for (std::size_t k = 0; k < count; ++k)
        result.values.push_back(first_weight * first.record.values[k] +
                                second_weight * second.record.values[k]);
    return result;
}

}  // namespace rockslope::record
