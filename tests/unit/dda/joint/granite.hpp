#pragma once

#include "dda/joint/barton_bandis.hpp"

namespace joint_tests {

/// The granite joint of Ma et al. (2017), Table 3, and the marble one.
inline dda::BartonStrength granite_strength() {
    return {12.8, 151e6, 34.6 * 0.017453292519943295};
}
inline dda::BartonStrength marble_strength() {
    return {12.9, 72e6, 38.3 * 0.017453292519943295};
}
constexpr double granite_peak = 1.25e-3, marble_peak = 0.3e-3;  ///< m

}  // namespace joint_tests
