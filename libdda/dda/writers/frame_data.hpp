#pragma once

#include "dda/analysis/state.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The blocks as cells: one polygon each; a block with holes is one polygon with a slit to each hole.
GridCells block_cells(const Model& model);
/// The quantities of a block, in the order of block_frame()'s columns.
std::vector<GridColumn> block_columns();
/// Corners, and per block: displacement and velocity of the centroid, stress and principal stresses,
/// rotation, id, material, and motion
/// (0 free, 1 fixed, 2 prescribed).
GridFrame block_frame(const Model& model, const State& state);
/// The same of the blocks that are there, with their cells: of a run that takes blocks out. @param cells of
/// all blocks.
GridFrame active_block_frame(const Model& model, const State& state, const GridCells& cells);

/// The quantities of a contact, in the order of contact_frame()'s columns.
std::vector<GridColumn> contact_columns();
/// The contacts that touch, and the open ones between faces that lie side by side: each half of an edge-edge
/// contact a line along its share of the joint, every other contact a vertex; state (0 open, 1 sliding, 2
/// locked), forces, stresses, slip, gap.
GridFrame contact_frame(const Model& model, const State& state);

}  // namespace rockslope::dda
