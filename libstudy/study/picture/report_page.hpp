#pragma once

#include <string>

#include "study/table/study_table.hpp"

namespace rockslope::study {

/// A report of a study as one HTML page without other files: what was planned, how many rows are done and why
/// others failed, the distribution of each measure, how it varies with each factor and from run to run, the
/// fragility curves of the plan, and what the measures depend on where the design tells.
std::string report_page(const StudyRows& rows, const std::string& title);

}  // namespace rockslope::study
