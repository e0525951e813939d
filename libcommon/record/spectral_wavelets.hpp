#pragma once

#include <span>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The target of a response spectrum at one period.
struct TargetOrdinate {
    double period = 0;        ///< s
    double acceleration = 0;  ///< m/s2, absolute
};

/// A sum of wavelets, m/s2 at the samples of the record, to be added to it. The response spectrum of the sum
/// meets the target if the extremes of the responses stay at their times (Lilhanand & Tseng 1988).
///
/// The response of an oscillator has one extreme per half cycle. Its largest extreme is required to become
/// the target. If the correction lifts another extreme above the target, that one is required to become the
/// target too: an active set, which keeps extremes from alternating. Every extreme above 85 % of the target
/// adds a wavelet, a tapered cosine of the damped frequency of the oscillator, cos(w' t) exp(-(t / g)^2)
/// with g = 3 * 1.178 f^-0.93, placed so that the response to it is largest at the extreme. Such wavelets
/// leave hardly any velocity (Al Atik & Abrahamson 2010; theirs are a third as long, and too broad in
/// frequency to separate oscillators 5 % apart). There are more wavelets than conditions; the amplitudes are
/// the regularised minimum-norm solution.
/// @param targets not empty; @param damping ratio, in (0, 1).
std::vector<double> matching_wavelets(const Accelerogram& record, std::span<const TargetOrdinate> targets,
                                      double damping);

}  // namespace rockslope::record
