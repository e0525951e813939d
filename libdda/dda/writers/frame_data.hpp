#pragma once

#include "dda/analysis/state.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The blocks as polygons; a block with holes is one polygon with a slit to each hole.
GridCells block_cells(const Model& model);
/// Names and widths of the columns of block_frame().
std::vector<GridColumn> block_columns();
/// All blocks: corners and, per block, displacement and velocity of the centroid, stress, principal stresses,
/// rotation, index, material and motion (0 free, 1 fixed, 2 prescribed).
GridFrame block_frame(const Model& model, const State& state);
/// The frame of a run with excavations: the blocks that are not removed, with their cells.
/// @param cells of all blocks.
GridFrame active_block_frame(const Model& model, const State& state, const GridCells& cells);

/// Names and widths of the columns of contact_frame().
std::vector<GridColumn> contact_columns();
/// The closed contacts, and the open ones between faces that lie side by side. A contact with a length is a
/// line along the joint, any other a vertex. Per contact: state (0 open, 1 sliding, 2 locked), forces,
/// stresses, slip, gap and the joint's history.
GridFrame contact_frame(const Model& model, const State& state);

}  // namespace rockslope::dda
