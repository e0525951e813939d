#pragma once

#include <span>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// What a response spectrum is to become at a period.
struct TargetOrdinate {
    double period = 0;        ///< s
    double acceleration = 0;  ///< m/s2, absolute
};

/// What to add to a record so that its response spectrum becomes what is aimed at, if responses grew
/// linearly: a sum of wavelets, m/s2, at the record's samples (Lilhanand & Tseng 1988).
///
/// An oscillator's response has many extremes, one a half cycle. At first its largest is to become the
/// target. If what that needs lifts another above its target, that one is to become its own target as well,
/// and so on: an active set, which keeps peaks from taking turns. Every extreme within 15 % of its target
/// brings a wavelet, a tapered cosine of the oscillator's own frequency, cos(w' t) exp(-(t / g)^2) with g = 3
/// * 1.178 f^-0.93, so placed that the oscillator responds most at the extreme; such leave hardly any
/// velocity (Al Atik & Abrahamson 2010, whose own are a third as long: too broad in frequency to tell
/// oscillators 5 % apart). There are more wavelets than conditions; the smallest amplitudes that do are
/// taken, slightly regularised.
/// @param targets not empty; @param damping of critical, in (0, 1).
std::vector<double> matching_wavelets(const Accelerogram& record, std::span<const TargetOrdinate> targets,
                                      double damping);

}  // namespace rockslope::record
