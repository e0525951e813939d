#pragma once

#include <cmath>

namespace rockslope::dda {

/// Distance from the origin, over the peak displacement, up to which a rough joint is mated, whether it slips
/// or opens there. Its dilation, and the energy that its spring bears, are a ten thousandth of those at the
/// peak.
constexpr double mating_distance = 1e-2;

/// Whether the walls of a rough joint fit together. @param position m, from the origin; @param
/// peak_displacement m.
inline bool is_mated(double position, double peak_displacement) {
    return std::abs(position) <= mating_distance * peak_displacement;
}

}  // namespace rockslope::dda
