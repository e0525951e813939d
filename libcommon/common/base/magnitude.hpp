#pragma once

#include <cmath>

namespace rockslope {

/// Largest magnitude of a number in a file or on a command line, SI or dimensionless; larger ones are
/// rejected. The mass of the Earth is 6e24 kg, so no rock slope comes near it. The product of ten such
/// numbers still fits a double, so areas, masses and energies do not overflow; with a limit of 1e100 they
/// would.
inline constexpr double largest_magnitude = 1e30;

/// Smallest value of a quantity that must be positive. Its reciprocal is largest_magnitude.
inline constexpr double smallest_positive = 1e-30;

/// Whether a number is finite and within largest_magnitude.
inline bool is_in_allowed_range(double value) {
    return std::abs(value) <= largest_magnitude;
}

}  // namespace rockslope
