#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "blockgen/fit/fit_map.hpp"

namespace rockslope::blockgen {

/// Values of a statistic at weights of the units (traces, lines, spacings); several at once.
using Statistic = std::function<std::vector<double>(const std::vector<double>& weights)>;

/// The values of a statistic with all weights 1, and intervals of 90 % from resamples in which each unit
/// occurs as often as a Poisson number of mean 1 says: the number of units then varies as that of a Poisson
/// process does. The ends of an interval are percentiles of the resamples, corrected for bias and, with few
/// units, for skewness and for the number of units (Efron 1987, BCa). A value that is not finite in a
/// resample is left out.
std::vector<Estimate> resampled(std::size_t units, const Statistic& statistic, std::uint64_t seed,
                                const std::string& name);

}  // namespace rockslope::blockgen
