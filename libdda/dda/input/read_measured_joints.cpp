#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/text.hpp"
#include "dda/contact/detect.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_mesh.hpp"

namespace rockslope::dda {

namespace {

constexpr double default_joint_tolerance = 1e-3;  // m, as in find_faces.cpp

const Vec2& start_point(const Model& model, EdgeIndex edge) {
    return model.vertices[start_of(edge)];
}
const Vec2& end_point(const Model& model, EdgeIndex edge) {
    return model.vertices[model.topology.end_of(edge)];
}

/// Distance of a point from an edge, m; infinite beyond the ends of the edge.
double distance(const Model& model, EdgeIndex edge, const Vec2& point) {
    const Vec2 along = end_point(model, edge) - start_point(model, edge);
    const Vec2 from = point - start_point(model, edge);
    const double fraction = from.dot(along) / along.squaredNorm();
    if (fraction < 0 || fraction > 1) return std::numeric_limits<double>::infinity();
    return std::abs(cross(along, from)) / along.norm();
}

/// The joint faces within `tolerance` of a point, the nearest of each block.
std::vector<EdgeIndex> faces_at(const Model& model, const Vec2& point, double tolerance) {
    const Topology& topology = model.topology;
    std::vector<EdgeIndex> faces;
    for (const EdgeIndex edge : topology.edges()) {
        if (!topology.joint_material[edge].exists() || !(distance(model, edge, point) <= tolerance)) continue;
        const bool same_block =
            !faces.empty() && topology.block_of_edge(faces.back()) == topology.block_of_edge(edge);
        if (!same_block)
            faces.push_back(edge);
        else if (distance(model, edge, point) < distance(model, faces.back(), point))
            faces.back() = edge;
    }
    return faces;
}

bool face_each_other(const Model& model, EdgeIndex a, EdgeIndex b) {
    const Vec2 one = (end_point(model, a) - start_point(model, a)).normalized();
    const Vec2 other = (end_point(model, b) - start_point(model, b)).normalized();
    return one.dot(other) < 0 && std::abs(cross(one, other)) <= parallel_tolerance;
}

/// Whether a face is that of the rock below the joint: it runs to the left. The rock on the left of a
/// vertical joint counts as below.
bool is_below(const Model& model, EdgeIndex edge) {
    const Vec2 along = end_point(model, edge) - start_point(model, edge);
    return along.x() < 0 || (along.x() == 0 && along.y() > 0);
}

MeasuredJoint read_measured_joint(const ConfigTable& table, Model& model) {
    MeasuredJoint joint;
    joint.name = table.string("name");
    for (const MeasuredJoint& other : model.measured_joints)
        if (other.name == joint.name)
            table.fail("name", "there are two measured joints '" + joint.name + "'", "names that differ");
    const std::array<double, 2> at = table.pair("at", Dimension::length);
    const Vec2 point = Vec2(at[0], at[1]) - model.origin;
    const double tolerance = positive(table, "tolerance", Dimension::length, default_joint_tolerance);
    std::vector<EdgeIndex> faces = faces_at(model, point, tolerance);
    if (faces.size() != 2 || !face_each_other(model, faces[0], faces[1]))
        table.fail("at",
                   faces.size() < 2 ? "no joint runs within " + shortest_text(tolerance) + " m of 'at' in [" +
                                          table.path() + "]"
                                    : "several joints meet at 'at' in [" + table.path() + "]",
                   "a point of a joint between two blocks");
    if (!is_below(model, faces[0])) std::swap(faces[0], faces[1]);
    joint.edge = faces[0];
    joint.point = add_material_point(model, model.topology.block_of_edge(faces[0]), point);
    joint.other_point = add_material_point(model, model.topology.block_of_edge(faces[1]), point);
    return joint;
}

}  // namespace

void read_measured_joints(const ConfigTable& run, Model& model) {
    for (const ConfigTable& table : run.array_of_tables("measured_joint"))
        model.measured_joints.push_back(read_measured_joint(table, model));
}

}  // namespace rockslope::dda
