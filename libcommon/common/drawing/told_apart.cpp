#include "common/drawing/told_apart.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope {

namespace {

bool coincide(const std::vector<Point>& a, const std::vector<Point>& b) {
    constexpr double within = 1;  // units of the page
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Point& p, const Point& q) {
        return std::hypot(p.x - q.x, p.y - q.y) <= within;
    });
}

}  // namespace

Stroke told_apart(Stroke stroke, const std::vector<Point>& line,
                  const std::vector<std::vector<Point>>& drawn) {
    const auto below = std::count_if(drawn.begin(), drawn.end(),
                                     [&](const std::vector<Point>& other) { return coincide(line, other); });
    // Shorter dashes over longer ones.
    if (below > 0) stroke.dashes = {8.0 / static_cast<double>(below), 8};
    return stroke;
}

}  // namespace rockslope
