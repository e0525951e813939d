#pragma once

#include <filesystem>
#include <vector>

#include "common/config/config_table.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Files that a model file refers to, in the order of reading.
using InputFiles = std::vector<std::filesystem::path>;

/// Adds the loads, [[fixed_point]] and [[initial_velocity]] to a model whose blocks are known.
/// @throws InputError for a point in no block, an unknown measured point, a block index out of range.
void read_loads(const ConfigTable& run, Model& model, InputFiles& files);

/// The block named by `block = index` or `at = [x, y]` in a table.
int read_block(const ConfigTable& table, const Model& model);

/// The table `history` of a load: a factor over time, 1 when absent.
TimeTable read_history(const ConfigTable& table, InputFiles& files);

/// A table of values over time: { file = ... } with two columns, or { times = [...], values = [...] }; times
/// strictly increasing, otherwise free.
TimeTable read_time_table(const ConfigTable& table, Dimension dimension, InputFiles& files);

}  // namespace rockslope::dda
