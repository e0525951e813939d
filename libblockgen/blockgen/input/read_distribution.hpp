#pragma once

#include "blockgen/input/distribution.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// Reads a distribution: a plain number, or a table with a law. @throws InputError
Distribution read_distribution(const ConfigTable& parent, std::string_view key, Dimension dimension);

/// Reads a distribution of lengths, m. @throws InputError when a draw can be negative, or can be zero and
/// `may_be_zero` is false.
Distribution read_length(const ConfigTable& table, std::string_view key, bool may_be_zero);

}  // namespace rockslope::blockgen
