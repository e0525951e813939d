#include "record/resample.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "record/butterworth.hpp"

namespace rockslope::record {

namespace {

constexpr double max_samples = 1e7;
constexpr int order = 8;
constexpr double corner_times_step = 0.4;  // 0.8 of the Nyquist frequency of the new step

std::vector<double> without_high_frequencies(const Accelerogram& record, double step) {
    const std::size_t extension = std::min(3 * (std::size_t{order} + 1), record.values.size() - 1);
    return filter_both_ways(butterworth(Pass::low, order, corner_times_step / step, record.step),
                            record.values, extension);
}

}  // namespace

Accelerogram resampled(const Accelerogram& record, double step) {
    const double intervals = std::floor(record.duration() / step * (1 + 1e-12));
    if (!(step > 0) || !(intervals >= 1) || !(intervals < max_samples))
        throw std::invalid_argument("a step must leave 2 to 10000000 samples of the record");
    const bool is_coarser = step > record.step * (1 + 1e-9);
    // A corner frequency above the old Nyquist frequency would filter nothing.
    const bool is_filtered = is_coarser && corner_times_step / step < 0.5 / record.step;
    const std::vector<double> values = is_filtered ? without_high_frequencies(record, step) : record.values;
    Accelerogram result{step, {}};
    for (std::size_t k = 0; k <= static_cast<std::size_t>(intervals); ++k) {
        const double position = static_cast<double>(k) * step / record.step;  // in old samples
        const auto before = std::min(static_cast<std::size_t>(position), values.size() - 2);
        result.values.push_back(std::lerp(values[before], values[before + 1],
                                          std::min(position - static_cast<double>(before), 1.0)));
    }
    return result;
}

}  // namespace rockslope::record
