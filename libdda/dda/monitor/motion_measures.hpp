#pragma once

#include <string>
#include <vector>

#include "dda/model/stage.hpp"
#include "record/measures.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope::dda {

/// Intensity measures of a motion as a stage applies it: scaled, and corrected for its drift.
struct MotionMeasures {
    std::string stage;
    std::string block;  ///< that it moves; empty: all prescribed blocks, or the frame of reference
    char axis = 'x';
    record::RecordMeasures measures;
    std::vector<record::SpectralOrdinate> spectrum;  ///< 5 % damped, at spectral_periods
};

/// s, the periods at which the spectral acceleration of a motion is reported.
inline constexpr double spectral_periods[] = {0.1, 0.2, 0.3, 0.5, 1, 2, 3};

/// The measures of all base motions of equal time steps, stage by stage, x before y. A direction at rest and
/// a table of uneven times have none.
std::vector<MotionMeasures> motion_measures(const std::vector<Stage>& stages);

}  // namespace rockslope::dda
