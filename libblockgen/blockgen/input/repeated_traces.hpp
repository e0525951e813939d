#pragma once

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// Removes the traces that repeat an earlier one, in either direction, also where one has further vertices on
/// its straight pieces. Notes how many of each name, of which other name, and whether their joint material is
/// another one. Names of which nothing is left are kept in `repeated_names`.
void drop_repeated_traces(SlopeModel& model);

}  // namespace rockslope::blockgen
