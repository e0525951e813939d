#pragma once

#include <filesystem>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// A response spectrum to be matched; straight between its points on logarithmic scales.
struct TargetSpectrum {
    std::vector<double> periods;        ///< s, increasing, positive, at least two
    std::vector<double> accelerations;  ///< m/s2, absolute, positive

    double at(double period) const;  ///< constant beyond the ends
};

/// Two columns with a heading that names the unit, "period (s),acceleration (g)". @throws InputError.
TargetSpectrum read_target_spectrum(const std::filesystem::path& path);

struct SpectralMatch {
    Accelerogram record;
    double mean_misfit = 0;     ///< of |response / target - 1| over the target's range, at 100 periods
    double largest_misfit = 0;  ///< likewise
};

/// A record changed until its response spectrum is the target: in each round every Fourier amplitude is
/// multiplied by target over response at its own period, phases kept, and the baseline corrected (Gasparini &
/// Vanmarcke 1976 do so for artificial motions). Beyond the target's range the factor is that of the nearest
/// end. The round of the smallest mean misfit goes on: at most as many rounds more add wavelets, see
/// matching_wavelets(), each as large a share of them as brings the spectrum nearest, unless the damping is
/// 0, until no period is more than 2 % off. The round of the smallest largest misfit is returned. The record
/// as it came counts as a round.
/// @param damping of critical, of the target; @param rounds 0 to 100. @throws std::invalid_argument for
/// parameters out of range, fewer than 4 samples, and a record without motion.
SpectralMatch match_spectrum(const Accelerogram& record, const TargetSpectrum& target, double damping,
                             int rounds);

}  // namespace rockslope::record
