#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The samples at the instants from `from` to `to`, s, which are rounded to samples; the first of them
/// becomes time 0. @throws std::invalid_argument when fewer than two samples are left.
Accelerogram trimmed(const Accelerogram& record, double from, double to);

/// Half a cosine from 0 to 1 over the first `length` seconds, and back to 0 over the last.
/// @param length s, not negative, at most half the record; otherwise std::invalid_argument.
Accelerogram tapered(const Accelerogram& record, double length);

}  // namespace rockslope::record
