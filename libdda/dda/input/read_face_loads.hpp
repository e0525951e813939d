#pragma once

#include "dda/input/read_loads.hpp"

namespace rockslope::dda {

/// N/m3, unit weight of fresh water.
inline constexpr double water_unit_weight = 9810;

/// One [[line_load]]: `along`, `pressure`, `pressure_end`, `traction`, `traction_end`, `history`.
/// @throws InputError for a line without a face on it, and for a table without `pressure` and `traction`.
LineLoad read_line_load(const ConfigTable& table, const Model& model, InputFiles& files);

/// The wetted faces of free blocks: joint faces, restricted to the table's `joint_material`, `joint_set` and
/// `region`.
/// @param free_faces_too whether the table has a key `free_faces`, true by default, that adds free faces.
/// @throws InputError for names that the model does not have, and if no face is wetted.
std::vector<EdgeIndex> read_wetted_faces(const ConfigTable& table, const Model& model, bool free_faces_too);

/// The head line `head`, [[x, y], ...] with x increasing, in the model's coordinates; or the water table of
/// the section, where `head` is "section" or absent. @throws InputError also when the section has none.
std::vector<Vec2> read_head(const ConfigTable& table, std::span<const Point> water_table, const Model& model);

}  // namespace rockslope::dda
