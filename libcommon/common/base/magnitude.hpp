#pragma once

#include <cmath>

namespace rockslope {

/// Numbers of larger magnitude are refused wherever a file or a command line gives them (SI; dimensionless
/// too). The Earth's mass is 6e24 kg: nothing in a rock slope comes near. Products of ten such numbers still
/// fit a double, so that areas, masses and energies of what was let in do not overflow; raising it to 1e100
/// lets them.
inline constexpr double largest_magnitude = 1e30;

/// A quantity that must be positive is at least this, so that its reciprocal is no larger than the other
/// limit.
inline constexpr double smallest_positive = 1e-30;

/// Finite and within the limit.
inline bool is_in_allowed_range(double value) {
    return std::abs(value) <= largest_magnitude;
}

}  // namespace rockslope
