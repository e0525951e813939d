#include "dda/io/measured_joint.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "blockgen/base/text.hpp"
#include "dda/contact/detect.hpp"
#include "dda/io/read_materials.hpp"
#include "dda/io/read_mesh.hpp"

namespace dda {

using blockgen::ConfigTable;
using blockgen::Dimension;

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
                   faces.size() < 2 ? "no joint runs within " + blockgen::shortest_text(tolerance) +
                                          " m of 'at' in [" + table.path() + "]"
                                    : "several joints meet at 'at' in [" + table.path() + "]",
                   "a point of a joint between two blocks");
    if (!is_below(model, faces[0])) std::swap(faces[0], faces[1]);
    const auto block_of = [&](int edge) { return model.topology.block_of[static_cast<std::size_t>(edge)]; };
    joint.edge = faces[0];
    joint.point = add_material_point(model, block_of(faces[0]), point);
    joint.other_point = add_material_point(model, block_of(faces[1]), point);
    return joint;
}

Vec2 displacement_of(const State& state, int point) {
    const auto p = static_cast<std::size_t>(point);
    return state.blocks.points[p] - state.displacement_origin[p];
}

/// Sums over the contacts of a joint.
struct Sums {
    double normal_force = 0, shear_force = 0, length = 0, strength = 0, slip = 0;
    int closed = 0;
    bool slides = false;
    const Contact* most_loaded = nullptr;

    void take(const Contact& contact) {
        if (contact.state == ContactState::open) return;
        ++closed;
        normal_force += contact.normal_force;
        shear_force += contact.shear_force;
        length += contact.length;
        slip += contact.slip;
        slides = slides || contact.state == ContactState::sliding;
        if (!most_loaded || contact.normal_force > most_loaded->normal_force) most_loaded = &contact;
    }
};

double smaller(const Strength& strength) {
    return std::min(strength.forward, strength.backward);
}

}  // namespace

void read_measured_joints(const ConfigTable& run, Model& model) {
    for (const ConfigTable& table : run.array_of_tables("measured_joint"))
        model.measured_joints.push_back(read_measured_joint(table, model));
}

JointReading read_joint(const Model& model, const State& state, const MeasuredJoint& joint) {
    const auto& vertices = state.blocks.vertices;
    const auto first = static_cast<std::size_t>(joint.edge);
    const auto last = static_cast<std::size_t>(model.topology.next[first]);
    const Vec2 tangent = (vertices[last] - vertices[first]).normalized();
    const Vec2 normal = -perpendicular(tangent);
    const Vec2 apart = displacement_of(state, joint.other_point) - displacement_of(state, joint.point);
    const int block = model.topology.block_of[first];
    const int other = model.material_points[static_cast<std::size_t>(joint.other_point)].block;

    JointReading reading;
    reading.displacement = -apart.dot(tangent);
    reading.dilation = apart.dot(normal);
    Sums sums;
    for (const Contact& contact : state.contacts.contacts) {
        if (std::minmax(contact.corner_block, contact.edge_block) != std::minmax(block, other)) continue;
        if (std::abs(cross(contact.normal, normal)) > parallel_tolerance) continue;
        sums.take(contact);
        const JointLaw& law = model.joint_material_at(contact.joint_material).law;
        if (contact.state != ContactState::open && !belongs_to_faces(law))
            sums.strength += smaller(strength(law, contact.history, contact.normal_force, contact.length));
    }
    if (sums.closed == 0) return reading;
    const JointLaw& law = model.joint_material_at(sums.most_loaded->joint_material).law;
    if (belongs_to_faces(law))
        sums.strength = smaller(strength(law, sums.most_loaded->history, sums.normal_force, sums.length));
    const double per_length = sums.length > 0 ? 1 / sums.length : 0;
    reading.shear_stress = -sums.shear_force * per_length;
    reading.normal_stress = sums.normal_force * per_length;
    reading.strength = sums.strength / model.strength_reduction * per_length;
    reading.slip = -sums.slip / sums.closed;
    reading.state = sums.slides ? ContactState::sliding : ContactState::locked;
    reading.record = record(law, sums.most_loaded->history);
    return reading;
}

}  // namespace dda
