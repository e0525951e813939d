#pragma once

#include "dda/analysis/state.hpp"
#include "dda/hdf/grid_frame.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The blocks as polygons; a block with holes is one polygon with a slit to each hole.
GridCells block_cells(const Model& model);
/// The quantities of block_frame() and texts about them: units, names of blocks and materials.
GridLayout block_layout(const Model& model);
/// All blocks: corners and, per block, displacement and velocity of the centroid, stress, principal stresses,
/// rotation, index, material and motion (0 free, 1 fixed, 2 prescribed); per corner, its displacement.
GridFrame block_frame(const Model& model, const State& state);
/// The frame of a run with excavations: the blocks that are not removed, with their cells.
/// @param cells of all blocks.
GridFrame active_block_frame(const Model& model, const State& state, const GridCells& cells);

/// The quantities of contact_frame() and texts about them: units, names of materials and joints.
GridLayout contact_layout(const Model& model);
/// The closed contacts, and the open ones between faces that lie side by side. A contact with a length is a
/// line along the joint, any other a vertex. Per contact: state (0 open, 1 sliding, 2 locked), forces,
/// stresses, slip, gap and the joint's history.
GridFrame contact_frame(const Model& model, const State& state);

}  // namespace rockslope::dda
