#include "line_points.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope {

namespace {

constexpr std::size_t drawn_intervals = 2000;

}  // namespace

Range padded(double low, double high) {
    const double size = high > low ? high - low : std::max(std::abs(high), 1e-9);
    return {low - 0.05 * size, high + 0.05 * size};
}

std::vector<Point> line_points(const std::vector<double>& time, const std::vector<double>& value,
                               double factor) {
    std::vector<Point> points;
    const std::size_t stride = std::max<std::size_t>(1, time.size() / drawn_intervals);
    for (std::size_t i = 0; i < time.size(); i += stride) {
        const auto first = value.begin() + static_cast<std::ptrdiff_t>(i);
        const auto last = value.begin() + static_cast<std::ptrdiff_t>(std::min(i + stride, time.size()));
        auto [low, high] = std::minmax_element(first, last);
        if (high < low) std::swap(low, high);
        points.push_back({time[low - value.begin()], *low * factor});
        if (high != low) points.push_back({time[high - value.begin()], *high * factor});
    }
    return points;
}

}  // namespace rockslope
