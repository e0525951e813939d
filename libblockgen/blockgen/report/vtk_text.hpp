#pragma once

#include <string>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// Blocks as polygons, traces and the water table as lines, in the legacy format of VTK (POLYDATA, ASCII),
/// which ParaView reads. Data of the cells: `block`, `block_material`, `motion` and `area` of polygons;
/// `trace` and `set` of traces; -1, or 0 for an area, where a cell has none; `kind` is 0 for a block, 1 for a
/// trace and 2 for the water table. Field data name the numbers of materials, sets and kinds. VTK knows no
/// holes: a hole is joined to the ring around it by a slit along the shortest free line.
std::string vtk_text(const BlockMesh& mesh, const std::vector<Trace>& traces);

}  // namespace rockslope::blockgen
