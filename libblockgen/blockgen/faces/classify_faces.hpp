#pragma once

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/faces/source_table.hpp"

namespace rockslope::blockgen {

/// The block of each face. Adjacent faces belong to one block unless a joint, the outline of the rock, a
/// change of material or an excavation separates them. Where excavations overlap, the rock belongs to the
/// excavation of the earliest stage.
struct FaceBlocks {
    static constexpr FaceBlockIndex outside = FaceBlockIndex::none();
    PerFace<FaceBlockIndex> block;  ///< `outside` where there is no rock
    PerFaceBlock<RockIndex> material;
    PerFaceBlock<ExcavationIndex> excavation;  ///< the excavation that removes the block, or none
    bool has_disjoint_voids = true;         ///< no hole or tunnel crosses the outline or overlaps another one
    std::vector<std::size_t> idle_tunnels;  ///< numbers of the tunnels that lie outside all outlines
};

/// The name of a block's material.
const std::string& material_of(const FaceBlocks& faces, const SlopeModel& model, FaceBlockIndex block);

/// Whether two blocks have the same material, and the same excavation or none.
bool have_same_rock(const FaceBlocks& faces, const SlopeModel& model, FaceBlockIndex block,
                    FaceBlockIndex other);

/// Classifies faces by a flood fill from the unbounded face. Crossing an edge of a hole, region, excavation
/// or tunnel toggles whether the face lies inside it (even-odd rule). The parts of the domain are counted by
/// the winding number instead, so that parts that overlap after noding are found exactly, and parts that only
/// touch are not taken for them.
/// @throws InputError when two parts overlap, with both named, or when a hole lies outside all parts.
FaceBlocks classify_faces(const NodedEdges& noded, const Subdivision& subdivision, const SlopeModel& model,
                          const SourceTable& table);

}  // namespace rockslope::blockgen
