#pragma once

#include <string>

#include "blockgen/fit/fit_map.hpp"

namespace rockslope::blockgen {

/// A slope model with the sets of a map, in the mapped area, which blockgen cuts as it is. Comments give the
/// intervals. @param source the file that was read.
std::string fitted_model_text(const MapFit& fit, const JointMap& map, const std::string& source);

/// The estimates as a table, with their intervals.
std::string fit_table(const MapFit& fit);

/// The estimates as JSON, in degrees and metres.
std::string fit_json(const MapFit& fit);

}  // namespace rockslope::blockgen
