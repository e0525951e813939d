#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "common/config/config_table.hpp"
#include "common/geometry/point.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Files that a model file refers to, in the order of reading.
using InputFiles = std::vector<std::filesystem::path>;

/// Adds the loads, [[fixed_point]] and [[initial_velocity]] to a model whose blocks are known.
/// @param water_table of the section, in the coordinates of its file; empty: it has none.
/// @throws InputError for a point in no block, an unknown measured point, a block index out of range.
void read_loads(const ConfigTable& run, std::span<const Point> water_table, Model& model, InputFiles& files);

/// Adds the [[viscous_boundary]] tables to a model whose blocks are known.
/// @throws InputError for a line without a face on it, and for a duplicate name.
void read_boundaries(const ConfigTable& run, Model& model);

/// The block that contains a point of the initial configuration. If none does, a block whose face is within
/// 1e-9 of the model's size of the point; nothing for a point outside all blocks.
std::optional<BlockIndex> find_block(const Model& model, const Vec2& point);

/// The block named by `block = index` or `at = [x, y]` in a table.
BlockIndex read_block(const ConfigTable& table, const Model& model);

/// The table `history` of a load: a factor over time, 1 when absent.
TimeTable read_history(const ConfigTable& table, InputFiles& files);

/// Values over time, from { file = ... } with two columns or { times = [...], values = [...] }. Times
/// increase strictly.
TimeTable read_time_table(const ConfigTable& table, Dimension dimension, InputFiles& files);

}  // namespace rockslope::dda
