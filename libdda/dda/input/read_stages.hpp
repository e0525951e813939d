#pragma once

#include <optional>
#include <vector>

#include "common/config/config_table.hpp"
#include "dda/input/read_loads.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"
#include "record/records.hpp"

namespace rockslope::dda {

/// Reads the [[stage]] tables. A key that the kind of a stage does not use is an unknown key.
/// @throws InputError, also for a base motion of a block that does not exist, and for an invalid record.
std::vector<Stage> read_stages(const ConfigTable& run, const Model& model, InputFiles& files);

/// Reads the [[stage.base_motion]] tables of a stage. Motions of prescribed blocks are added to its base
/// motions, those applied as a body force to its frame motions. The stage's step must be set.
/// @throws InputError for a block that does not exist or is not prescribed, and for an invalid motion.
void read_base_motions(const ConfigTable& table, const Model& model, InputFiles& files, Stage& stage);

/// Reads the table [stage.stop] of a stage; nothing without one. The measured points and regions must be
/// known. @throws InputError for an unknown name, and for both a point and a region.
std::optional<StopLimit> read_stop_limit(const ConfigTable& stage, const Model& model);

/// Reads the record declared by the keys `file`, `format`, `channel`, `point`, `quantity` and `unit`.
record::Record read_axis_record(const ConfigTable& axis, InputFiles& files);

/// The table with its times increased by `delay`, s.
TimeTable delayed(const TimeTable& table, double delay);

/// Reads the [[stage.incident_wave]] tables of a stage.
/// @throws InputError for the name of no viscous boundary, or of one with a free field.
std::vector<IncidentWave> read_incident_waves(const ConfigTable& stage, const Model& model,
                                              InputFiles& files);

}  // namespace rockslope::dda
