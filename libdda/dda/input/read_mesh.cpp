#include "dda/input/read_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"

namespace rockslope::dda {

namespace {

/// The index of each name in the list of materials of the model file.
template <class Material>
std::vector<std::size_t> resolve(const std::vector<std::string>& material_names,
                                 const std::vector<Material>& materials, const std::string& table,
                                 const std::string& mesh_file) {
    std::vector<std::string> names;
    for (const Material& material : materials) names.push_back(material.name);
    std::vector<std::size_t> indices;
    for (const std::string& name : material_names) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            const auto nearest = nearest_word(name, names);
            throw InputError({mesh_file},
                             "needs the " + table + " '" + name + "', which the model file does not have" +
                                 (nearest ? " (it has '" + *nearest + "')" : ""),
                             "a table [" + table + "." + name + "]");
        }
        indices.push_back(found - names.begin());
    }
    return indices;
}

Motion motion_of(blockgen::BlockMotion motion) {
    switch (motion) {
        case blockgen::BlockMotion::fixed:
            return Motion::fixed;
        case blockgen::BlockMotion::prescribed:
            return Motion::prescribed;
        default:
            return Motion::free;
    }
}

Vec2 vector_of(const Point& point) {
    return {point.x, point.y};
}

/// Origin of the model's coordinates, m: zero for a model near zero, else a point of whole metres near its
/// middle, so that coordinates relative to it are exact.
Vec2 origin_of(const blockgen::BlockMesh& mesh) {
    constexpr double far = 16;  // distance from zero over the model's size: 4 bits of a coordinate are lost
    if (mesh.vertices.empty()) return Vec2::Zero();
    Vec2 low = vector_of(mesh.vertices.front()), high = low;
    for (const Point& point : mesh.vertices) {
        low = low.cwiseMin(vector_of(point));
        high = high.cwiseMax(vector_of(point));
    }
    const Vec2 middle = (low + high) / 2;
    if (middle.cwiseAbs().maxCoeff() < far * (high - low).maxCoeff()) return Vec2::Zero();
    return {std::round(middle.x()), std::round(middle.y())};
}

/// m, largest distance of a straight corner from the line through its neighbours: two cells of the cutter's
/// default grid.
constexpr double straightness_tolerance = 2e-6;

/// Indices of the vertices of a ring that become corners: all, or with StraightCorners::drop those at which
/// the face turns or its joint changes. The others mark corners of blocks on the other side.
std::vector<std::size_t> kept_corners(const blockgen::BlockMesh& mesh, blockgen::BlockIndex block,
                                      std::size_t ring, StraightCorners straight) {
    const auto vertices = mesh.ring(block, ring);
    const auto marks = mesh.ring_marks(block, ring);
    const std::size_t count = vertices.size();
    const auto at = [&](std::size_t k) { return vector_of(mesh.vertices[vertices[k % count]]); };
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t before = (k + count - 1) % count;
        const Vec2 from = at(before), along = at(k + 1) - from, arm = at(k) - from;
        const double length = along.norm();
        const bool is_straight = marks[before].joint_material == marks[k].joint_material &&
                                 marks[before].joint == marks[k].joint &&
                                 std::abs(cross(along, arm)) <= straightness_tolerance * length &&
                                 arm.dot(along) > 0 && arm.dot(along) < length * length;
        if (straight == StraightCorners::keep || !is_straight) kept.push_back(k);
    }
    return kept;
}

void add_blocks(const blockgen::BlockMesh& mesh,
                const blockgen::PerBlockMaterial<std::size_t>& block_materials,
                const blockgen::PerJointMaterial<std::size_t>& joint_materials, StraightCorners straight,
                Model& model) {
    for (const blockgen::BlockIndex block : mesh.blocks()) {
        std::vector<std::vector<std::size_t>> kept;
        std::vector<int> ring_sizes;
        for (std::size_t ring = 0; ring < mesh.ring_count(block); ++ring) {
            kept.push_back(kept_corners(mesh, block, ring, straight));
            ring_sizes.push_back(kept.back().size());
        }
        EdgeIndex edge = model.topology.corner_count();
        model.topology.add_block(ring_sizes);
        for (std::size_t ring = 0; ring < mesh.ring_count(block); ++ring) {
            for (const std::size_t k : kept[ring]) {
                const blockgen::VertexIndex vertex = mesh.ring(block, ring)[k];
                model.vertices.push_back(vector_of(mesh.vertices[vertex]) - model.origin);
                const blockgen::EdgeMark& mark = mesh.ring_marks(block, ring)[k];
                const bool is_joint = mark.joint_material != blockgen::EdgeMark::no_joint;
                if (is_joint) model.topology.joint_material[edge] = joint_materials[mark.joint_material];
                model.topology.joint[edge] = mark.joint.value();
                ++edge;
            }
        }
        model.block_material.push_back(block_materials[mesh.block_material[block]]);
        model.motion.push_back(motion_of(mesh.motion[block]));
        model.block_name.push_back(mesh.motion_name[block]);
    }
}

}  // namespace

PointIndex add_material_point(Model& model, BlockIndex block, const Vec2& position) {
    model.material_points.push_back({block, position});
    return model.material_points.size() - 1;
}

void add_mesh(const blockgen::BlockMesh& mesh, const std::string& mesh_file,
              const std::vector<BoltMaterial>& bolt_materials, StraightCorners straight, Model& model) {
    model.origin = origin_of(mesh);
    add_blocks(mesh, resolve(mesh.block_materials, model.block_materials, "block_material", mesh_file),
               resolve(mesh.joint_materials, model.joint_materials, "joint_material", mesh_file), straight,
               model);
    for (const blockgen::Joint& joint : mesh.joints) model.joint_sets.push_back(joint.set);
    for (const blockgen::MeasuredPoint& point : mesh.measured_points)
        model.measured_points.push_back(
            {point.name,
             add_material_point(model, point.block.value(), vector_of(point.position) - model.origin)});

    for (const blockgen::ExcavatedBlocks& e : mesh.excavations) {
        model.excavations.push_back({e.name, e.stage, {}});
        for (const blockgen::BlockIndex block : e.blocks)
            model.excavations.back().blocks.push_back(block.value());
    }

    std::vector<std::string> material_names;
    for (const blockgen::Bolt& bolt : mesh.bolts) material_names.push_back(bolt.material);
    const std::vector<std::size_t> materials =
        resolve(material_names, bolt_materials, "bolt_material", mesh_file);
    for (std::size_t i = 0; i < mesh.bolts.size(); ++i) {
        const blockgen::Bolt& bolt = mesh.bolts[i];
        const BoltMaterial& material = bolt_materials[materials[i]];
        model.bolts.push_back(
            {bolt.name,
             add_material_point(model, bolt.first_block.value(), vector_of(bolt.first) - model.origin),
             add_material_point(model, bolt.second_block.value(), vector_of(bolt.second) - model.origin),
             material.axial_stiffness, material.pretension, material.yield_force});
    }
}

}  // namespace rockslope::dda
