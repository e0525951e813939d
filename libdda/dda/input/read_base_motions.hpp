#pragma once

#include "dda/input/read_loads.hpp"
#include "dda/model/stage.hpp"
#include "record/records.hpp"

namespace rockslope::dda {

/// The [[stage.base_motion]] tables of a stage whose step is known: what moves prescribed blocks goes to its
/// base motions, what is felt as a body force to its frame motions.
/// @throws InputError for a block that is not there or not prescribed, and for what cannot be a motion.
void read_base_motions(const ConfigTable& table, const Model& model, InputFiles& files, Stage& stage);

/// The record that `file`, `format`, `channel`, `point`, `quantity` and `unit` of a table tell.
record::Record read_axis_record(const ConfigTable& axis, InputFiles& files);

/// A table whose times are later by the table's `delay`, s, 0 unless it stands there.
TimeTable delayed(const TimeTable& table, double delay);

}  // namespace rockslope::dda
