#pragma once

#include "common/drawing/canvas.hpp"
#include "study/analysis/fragility.hpp"
#include "study/analysis/sensitivity_study.hpp"
#include "study/csv/csv_text.hpp"

namespace rockslope::study {

/// A fragility curve with its band, the share of failures at each intensity of several rows, and the rows
/// themselves, at 0 and 1. Where there is no curve, the rows and what can be said.
Canvas draw_fragility(const Fragility& fragility);

/// The median of a fragility curve with its band against the number of groups, from convergence_table().
Canvas draw_convergence(const Fragility& fragility, const TextTable& convergence);

/// Bars for each factor, the most important on top: indices, effects, or a tornado.
Canvas draw_sensitivity(const SensitivityStudy& study);

}  // namespace rockslope::study
