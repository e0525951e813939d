#pragma once

#include <span>

#include "dda/record/accelerogram.hpp"

namespace dda {

/// What a response spectrum is to become at a period.
struct SpectralAim {
    double period = 0;        ///< s
    double acceleration = 0;  ///< m/s2, absolute
};

/// Adds a short wavelet to the record for each aim, so that each oscillator's largest response, which stays
/// when it is, becomes what is aimed at (Lilhanand & Tseng 1988). The wavelets are tapered cosines of the
/// oscillators' own frequencies, cos(w' t) exp(-(t / g)^2) with g = 1.178 f^-0.93, which leave hardly any
/// velocity (Al Atik & Abrahamson 2010); their sizes solve a linear system, regularised so that neighbours do
/// not fight. `share` of the way is gone: responses do not grow linearly where another peak takes over.
/// @param damping of critical, in (0, 1).
Accelerogram with_wavelets(const Accelerogram& record, std::span<const SpectralAim> aims, double damping,
                           double share);

}  // namespace dda
