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

}  // namespace rockslope::blockgen
