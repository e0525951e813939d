#pragma once

#include <filesystem>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// A response spectrum to be matched, linear between its points on logarithmic scales.
struct TargetSpectrum {
    std::vector<double> periods;        ///< s, increasing, positive, at least two
    std::vector<double> accelerations;  ///< m/s2, absolute, positive

    double at(double period) const;  ///< m/s2; constant beyond the first and last period
};

/// Reads two columns with a heading that states the unit, "period (s),acceleration (g)". @throws InputError.
TargetSpectrum read_target_spectrum(const std::filesystem::path& path);

struct SpectralMatch {
    Accelerogram record;
    // Misfits |response / target - 1| at 100 periods over the range of the target.
    double mean_misfit = 0;
    double largest_misfit = 0;
};

/// Changes a record so that its response spectrum matches the target, in two stages of at most `rounds`
/// rounds:
///   1. Each round multiplies every Fourier amplitude by target / response at its period, keeps the phases
///      and corrects the baseline (Gasparini & Vanmarcke 1976, for artificial motions). Beyond the range of
///      the target the factor is that of the nearest end. The round with the smallest mean misfit is kept.
///   2. Unless the damping is 0, each round adds wavelets, see matching_wavelets(), times the step length
///      that gives the smallest misfit, until the largest misfit is 2 % or less. The round with the smallest
///      largest misfit is returned.
/// In both stages the initial record counts as a round.
/// @param damping ratio of the target; @param rounds 0 to 100. @throws std::invalid_argument for parameters
/// out of range, fewer than 4 samples, and a record without motion.
SpectralMatch match_spectrum(const Accelerogram& record, const TargetSpectrum& target, double damping,
                             int rounds);

}  // namespace rockslope::record
