#include "record/trim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockslope::record {

Accelerogram trimmed(const Accelerogram& record, double from, double to) {
    if (!(from >= 0) || !(to > from))
        throw std::invalid_argument("the end of a cut must be later than its start");
    const double last = static_cast<double>(record.values.size()) - 1;
    const double first_kept = std::round(from / record.step);
    const double last_kept = std::min(std::round(to / record.step), last);
    if (!(last_kept >= first_kept + 1))
        throw std::invalid_argument("fewer than two samples lie between the start and the end of a cut");
    const auto begin = record.values.begin();
    return {record.step,
            {begin + static_cast<std::ptrdiff_t>(first_kept),
             begin + static_cast<std::ptrdiff_t>(last_kept) + 1}};
}

Accelerogram tapered(const Accelerogram& record, double length) {
    if (!(length >= 0) || !(length <= record.duration() / 2))
        throw std::invalid_argument("a taper must be between 0 and half the record long");
    Accelerogram result = record;
    const std::size_t count = result.values.size();
    for (std::size_t k = 0; k < count; ++k) {
        const double to_end = static_cast<double>(std::min(k, count - 1 - k)) * record.step;
        if (to_end < length) result.values[k] *= (1 - std::cos(std::numbers::pi * to_end / length)) / 2;
    }
    return result;
}

}  // namespace rockslope::record
