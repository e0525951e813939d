#pragma once

#include "dda/input/read_loads.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// Adds the [[viscous_boundary]] tables to a model whose blocks are known.
/// @throws InputError for a line along no face, and for a name that stands twice.
void read_boundaries(const ConfigTable& run, Model& model);

/// The [[stage.incident_wave]] tables of a stage.
/// @throws InputError for a name that no boundary has.
std::vector<IncidentWave> read_incident_waves(const ConfigTable& stage, const Model& model,
                                              InputFiles& files);

}  // namespace rockslope::dda
