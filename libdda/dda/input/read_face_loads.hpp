#pragma once

#include "dda/input/read_loads.hpp"

namespace rockslope::dda {

/// N/m3, of fresh water; the usual round number.
inline constexpr double water_unit_weight = 9810;

/// One [[line_load]]: `along`, `pressure`, `pressure_end`, `traction`, `traction_end`, `history`.
/// @throws InputError for a line along no face, and for a load of nothing.
LineLoad read_line_load(const ConfigTable& table, const Model& model, InputFiles& files);

/// The faces that water wets, of blocks that can move: those of joints, or of the `joint_material` and
/// `joint_set` that the table names, and inside its `region` if it has one. @param free_faces_too with the
/// key `free_faces`, true by default.
/// @throws InputError for names that the model does not have, and where no face is wetted.
std::vector<int> read_wetted_faces(const ConfigTable& table, const Model& model, bool free_faces_too);

/// The head line `head`, [[x, y], ...] with x increasing, in the model's coordinates.
std::vector<Vec2> read_head(const ConfigTable& table, const Model& model);

}  // namespace rockslope::dda
