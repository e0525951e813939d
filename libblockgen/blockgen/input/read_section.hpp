#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// Reads [section] into model.section, if there is one and it has not been read yet: the azimuth of the x
/// axis, or the section line from which it follows. @throws InputError for a line without length, and for an
/// azimuth that is not that of the line.
void read_section(const ConfigTable& root, SlopeModel& model);

/// The section line. @param table and @param key that need it. @throws InputError there when [section] has
/// none.
const SectionLine& section_line(const ConfigTable& root, const ConfigTable& table, const std::string& key,
                                SlopeModel& model);

}  // namespace rockslope::blockgen
