#pragma once

#include "blockgen/mesh/block_mesh.hpp"
#include "common/config/config_table.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The properties of a bolt material; Bolt entries of the block file name one. Units as in BoltSpec.
struct BoltMaterial {
    std::string name;
    double axial_stiffness = 0;
    double pretension = 0;
    double yield_force = 0;
};

/// What becomes of corners at which a face goes straight on with the same joint: where another block ends
/// beside it. Dropped ones leave fewer contacts; those that are kept share the length of the face with its
/// ends, also while they bear nothing.
enum class StraightCorners { keep, drop };

/// Adds the blocks of a mesh to a model whose materials have been read: topology, vertices, motions, measured
/// points and bolts with their material points. Neighbours share no corner any more.
/// @throws InputError naming `mesh_file` and the material that the model lacks.
void add_mesh(const blockgen::BlockMesh& mesh, const std::string& mesh_file,
              const std::vector<BoltMaterial>& bolt_materials, StraightCorners straight, Model& model);

/// Appends a material point and returns its index.
int add_material_point(Model& model, int block, const Vec2& position);

/// Adds the [[measured_joint]] tables to a model whose blocks are known.
/// @throws InputError where a name is given twice, or where no joint or more than one lies at the place.
void read_measured_joints(const ConfigTable& run, Model& model);

}  // namespace rockslope::dda
