#include "record/rotate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockslope::record {

Accelerogram rotated(const HorizontalComponent& first, const HorizontalComponent& second, double azimuth) {
    const double step = first.record.step;
    if (!(std::abs(second.record.step - step) <= 1e-9 * step))
        throw std::invalid_argument("the two components have different steps");
    const double degree = std::numbers::pi / 180;
    const double between = std::sin((second.azimuth - first.azimuth) * degree);
    if (!(std::abs(between) >= std::sin(10 * degree)) || !std::isfinite(azimuth))
        throw std::invalid_argument(
            "azimuths must be finite, and the components 10 degrees or more off one line");
    // e(azimuth) as a combination of e(first) and e(second).
    const double share_of_first = std::sin((second.azimuth - azimuth) * degree) / between;
    const double share_of_second = std::sin((azimuth - first.azimuth) * degree) / between;
    // With g_i the dual vectors, a = sum a_i g_i and e . g_i is the share of e_i in e.
    Accelerogram result{step, {}};
    const std::size_t count = std::min(first.record.values.size(), second.record.values.size());
    for (std::size_t k = 0; k < count; ++k)
        result.values.push_back(share_of_first * first.record.values[k] +
                                share_of_second * second.record.values[k]);
    return result;
}

}  // namespace rockslope::record
