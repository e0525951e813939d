#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "blockgen/input/orientation.hpp"

namespace rockslope::blockgen {

/// Mean and scatter of the poles of planes.
struct FisherEstimate {
    std::size_t count = 0;
    Pole mean;                ///< upward
    std::optional<double> k;  ///< concentration; nothing for fewer than two different planes
};

/// Estimates Fisher's distribution (1953) from poles, which there must be. A pole has no sign: each is taken
/// on the side of the axis with the largest sum of squared projections. The mean is the
/// direction of their sum, of length R, and K = (n - 1) / (n - R). K is biased upwards where poles of one set
/// lie at more than a right angle to its axis.
FisherEstimate fisher_estimate(std::span<const Pole> poles);

}  // namespace rockslope::blockgen
