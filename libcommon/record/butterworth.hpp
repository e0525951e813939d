#pragma once

#include <array>
#include <vector>

namespace rockslope::record {

/// A filter of second order, y_k = b0 x_k + b1 x_(k-1) + b2 x_(k-2) - a1 y_(k-1) - a2 y_(k-2).
struct FilterSection {
    double b0 = 1, b1 = 0, b2 = 0;
    double a1 = 0, a2 = 0;
};

enum class Pass { low, high };

/// A digital Butterworth filter as a cascade of sections: the poles of the analogue filter at the corner
/// frequency, w = 2 / h tan(pi f h) (prewarped), taken into the z plane by the bilinear transform. An odd
/// order has one section of first order, the last.
/// @param corner Hz, where one pass keeps 1/sqrt(2) of the amplitude: positive, below half the sampling rate.
/// @param order 1 to 12; @param step s between samples. @throws std::invalid_argument.
std::vector<FilterSection> butterworth(Pass pass, int order, double corner, double step);

/// Runs a filter forwards and then backwards, so that no frequency is delayed and each is filtered twice. At
/// both ends the signal goes on for `extension` samples as its own image turned about the end point; each run
/// starts in the steady state of its first value (Gustafsson 1996 gives the alternatives).
/// @param extension less than the number of samples, otherwise std::invalid_argument. 0: none.
std::vector<double> filter_both_ways(const std::vector<FilterSection>& filter,
                                     const std::vector<double>& signal, std::size_t extension);

}  // namespace rockslope::record
