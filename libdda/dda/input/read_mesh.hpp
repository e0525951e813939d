#pragma once

#include "blockgen/mesh/block_mesh.hpp"
#include "common/config/config_table.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A bolt material; the bolts of the block file refer to it by name. Units as in BoltSpec.
struct BoltMaterial {
    std::string name;
    double axial_stiffness = 0;
    double pretension = 0;
    double yield_force = 0;
};

/// Treatment of corners at which a face goes straight on with the same joint, because another block ends
/// there. Dropping them gives fewer contacts. Contacts of kept ones take part of the face's contact length,
/// also while they bear no force.
enum class StraightCorners { keep, drop };

/// Adds the blocks of a mesh to a model whose materials have been read: topology, vertices, motions, measured
/// points, excavations, and bolts with their material points. Each block gets its own corners.
/// @throws InputError that names `mesh_file` and the material that the model lacks.
void add_mesh(const blockgen::BlockMesh& mesh, const std::string& mesh_file,
              const std::vector<BoltMaterial>& bolt_materials, StraightCorners straight, Model& model);

/// Appends a material point and returns its index.
PointIndex add_material_point(Model& model, BlockIndex block, const Vec2& position);

/// Adds the [[measured_joint]] tables to a model whose blocks are known.
/// @throws InputError for a duplicate name, and for a point with no joint or several.
void read_measured_joints(const ConfigTable& run, Model& model);

/// Adds the [[measured_region]] tables to a model whose blocks are known: the free blocks whose centroid lies
/// in `polygon`, or that have the material `block_material`, or both.
/// @throws InputError for a duplicate name, and for a region without a free block.
void read_measured_regions(const ConfigTable& run, Model& model);

}  // namespace rockslope::dda
