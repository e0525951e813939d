#pragma once

#include <vector>

namespace rockslope::record {

/// A second-order section, y_k = b0 x_k + b1 x_(k-1) + b2 x_(k-2) - a1 y_(k-1) - a2 y_(k-2).
struct FilterSection {
    double b0 = 1, b1 = 0, b2 = 0;
    double a1 = 0, a2 = 0;
};

enum class Pass { low, high };

/// A digital Butterworth filter as a cascade of sections, from the analogue filter by the bilinear
/// transform. The corner frequency is prewarped, w = 2 / h tan(pi f h). In an odd order the last section is
/// of first order.
/// @param corner Hz, where one pass keeps 1/sqrt(2) of the amplitude; positive, below half the sampling rate.
/// @param order 1 to 12; @param step s between samples. @throws std::invalid_argument.
std::vector<FilterSection> butterworth(Pass pass, int order, double corner, double step);

/// Zero-phase filter: runs the filter forwards and then backwards. The signal is first extended at both ends
/// by `extension` samples, point-symmetric about the end sample. Each run starts in the steady state of its
/// first value (Gustafsson 1996 gives the alternatives).
/// @param extension 0 or more, less than the number of samples; otherwise std::invalid_argument.
std::vector<double> filter_both_ways(const std::vector<FilterSection>& filter,
                                     const std::vector<double>& signal, std::size_t extension);

}  // namespace rockslope::record
