#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The samples between the times `from` and `to`, s, both rounded to samples. The first one becomes time 0.
/// @throws std::invalid_argument if fewer than two samples are left.
Accelerogram trimmed(const Accelerogram& record, double from, double to);

/// The record times a cosine taper: half a cosine from 0 to 1 over the first `length` seconds, and from 1 to
/// 0 over the last.
/// @param length s, not negative, at most half the record; otherwise std::invalid_argument.
Accelerogram tapered(const Accelerogram& record, double length);

}  // namespace rockslope::record
