#pragma once

#include <cmath>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// The length of a trace along its points, m.
inline double length_of(const Trace& trace) {
    double length = 0;
    for (std::size_t k = 0; k + 1 < trace.points.size(); ++k)
        length +=
            std::hypot(trace.points[k + 1].x - trace.points[k].x, trace.points[k + 1].y - trace.points[k].y);
    return length;
}

/// The point at half the length of a trace.
inline Point middle_of(const Trace& trace) {
    double remaining = length_of(trace) / 2;
    for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
        const Point &a = trace.points[k], &b = trace.points[k + 1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (remaining <= length && length > 0)
            return {a.x + remaining / length * (b.x - a.x), a.y + remaining / length * (b.y - a.y)};
        remaining -= length;
    }
    return trace.points.back();
}

}  // namespace rockslope::blockgen
