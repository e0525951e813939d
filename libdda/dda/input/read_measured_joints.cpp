#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/text.hpp"
#include "dda/contact/detect.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_mesh.hpp"

namespace rockslope::dda {

namespace {

constexpr double default_tolerance = 1e-3;  // m, as for faces

const Vec2& start_of(const Model& model, int edge) {
    return model.vertices[static_cast<std::size_t>(edge)];
}
const Vec2& end_of(const Model& model, int edge) {
    return start_of(model, model.topology.next[static_cast<std::size_t>(edge)]);
}

/// m, of a point from an edge beside it; infinite past the edge's ends.
double distance(const Model& model, int edge, const Vec2& point) {
    const Vec2 along = end_of(model, edge) - start_of(model, edge);
    const Vec2 from = point - start_of(model, edge);
    const double share = from.dot(along) / along.squaredNorm();
    if (share < 0 || share > 1) return std::numeric_limits<double>::infinity();
    return std::abs(cross(along, from)) / along.norm();
}

/// The faces of joints at a place, the nearest of each block.
std::vector<int> faces_at(const Model& model, const Vec2& point, double tolerance) {
    const Topology& topology = model.topology;
    std::vector<int> faces;
    for (int edge = 0; edge < topology.corner_count(); ++edge) {
        const auto e = static_cast<std::size_t>(edge);
        if (topology.joint_material[e] < 0 || !(distance(model, edge, point) <= tolerance)) continue;
        const bool same_block = !faces.empty() && topology.block_of[static_cast<std::size_t>(faces.back())] ==
                                                      topology.block_of[e];
        if (!same_block)
            faces.push_back(edge);
        else if (distance(model, edge, point) < distance(model, faces.back(), point))
            faces.back() = edge;
    }
    return faces;
}

bool face_each_other(const Model& model, int a, int b) {
    const Vec2 one = (end_of(model, a) - start_of(model, a)).normalized();
    const Vec2 other = (end_of(model, b) - start_of(model, b)).normalized();
    return one.dot(other) < 0 && std::abs(cross(one, other)) <= parallel_tolerance;
}

/// The rock below has its face run to the left; of an upright joint that is the rock on the left.
bool is_below(const Model& model, int edge) {
    const Vec2 along = end_of(model, edge) - start_of(model, edge);
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
    const double tolerance = positive(table, "tolerance", Dimension::length, default_tolerance);
    std::vector<int> faces = faces_at(model, point, tolerance);
    if (faces.size() != 2 || !face_each_other(model, faces[0], faces[1]))
        table.fail("at",
                   faces.size() < 2 ? "no joint runs within " + shortest_text(tolerance) + " m of 'at' in [" +
                                          table.path() + "]"
                                    : "several joints meet at 'at' in [" + table.path() + "]",
                   "a point of a joint between two blocks");
    if (!is_below(model, faces[0])) std::swap(faces[0], faces[1]);
    const auto block_of = [&](int edge) { return model.topology.block_of[static_cast<std::size_t>(edge)]; };
    joint.edge = faces[0];
    joint.point = add_material_point(model, block_of(faces[0]), point);
    joint.other_point = add_material_point(model, block_of(faces[1]), point);
    return joint;
}

}  // namespace

void read_measured_joints(const ConfigTable& run, Model& model) {
    for (const ConfigTable& table : run.array_of_tables("measured_joint"))
        model.measured_joints.push_back(read_measured_joint(table, model));
}

}  // namespace rockslope::dda
