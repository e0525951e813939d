#pragma once

#include "blockgen/input/distribution.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// A plain number, or a table with a law. @throws InputError
Distribution read_distribution(const ConfigTable& parent, std::string_view key, Dimension dimension);

/// A distribution of lengths no draw of which is negative, or zero unless it may be.
Distribution read_length(const ConfigTable& table, std::string_view key, bool may_be_zero);

}  // namespace rockslope::blockgen
