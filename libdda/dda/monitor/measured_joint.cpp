#include "dda/monitor/measured_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

Vec2 displacement_of(const State& state, PointIndex point) {
    return state.blocks.points[point] - state.displacement_origin[point];
}

/// Sums over the closed contacts of a joint.
struct ContactSums {
    double normal_force = 0, shear_force = 0, length = 0, strength = 0, slip = 0;
    int closed = 0;
    bool slides = false;
    const Contact* most_loaded = nullptr;

    void add(const Contact& contact) {
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

/// The length of an edge and of the edges of its block before and after it that continue it straight, m.
double face_length(const Model& model, EdgeIndex edge) {
    const Topology& topology = model.topology;
    const auto along = [&](CornerIndex from) {
        return Vec2(model.vertices[topology.next[from]] - model.vertices[from]);
    };
    const Vec2 direction = along(start_of(edge)).normalized();
    const auto is_straight = [&](CornerIndex from) {
        const Vec2 other = along(from);
        return std::abs(cross(direction, other)) < parallel_tolerance * other.norm() &&
               direction.dot(other) > 0;
    };
    double length = along(start_of(edge)).norm();
    for (CornerIndex k = topology.next[start_of(edge)]; is_straight(k); k = topology.next[k])
        length += along(k).norm();
    for (CornerIndex k = topology.previous[start_of(edge)]; is_straight(k); k = topology.previous[k])
        length += along(k).norm();
    return length;
}

/// The edge of a block that is nearest to a point before any block moves.
EdgeIndex nearest_edge(const Model& model, BlockIndex block, const Vec2& point) {
    EdgeIndex nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (const CornerIndex from : model.topology.corners_of(block)) {
        const Vec2& start = model.vertices[from];
        const Vec2 edge = model.vertices[model.topology.next[from]] - start;
        const double fraction = std::clamp((point - start).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        const double here = (start + fraction * edge - point).norm();
        if (!(here < distance)) continue;
        distance = here;
        nearest = edge_from(from);
    }
    return nearest;
}

double smaller(const Strength& strength) {
    return std::min(strength.forward, strength.backward);
}

}  // namespace

double joint_length(const Model& model, const MeasuredJoint& joint) {
    const MaterialPoint& other = model.material_points[joint.other_point];
    return std::min(face_length(model, joint.edge),
                    face_length(model, nearest_edge(model, other.block, other.position)));
}

JointReading read_joint(const Model& model, const State& state, const MeasuredJoint& joint) {
    const auto& vertices = state.blocks.vertices;
    const Vec2 tangent =
        (vertices[model.topology.end_of(joint.edge)] - vertices[start_of(joint.edge)]).normalized();
    const Vec2 normal = -perpendicular(tangent);
    const Vec2 relative_displacement =
        displacement_of(state, joint.other_point) - displacement_of(state, joint.point);
    const BlockIndex block = model.topology.block_of_edge(joint.edge);
    const BlockIndex other = model.material_points[joint.other_point].block;

    JointReading reading;
    reading.displacement = -relative_displacement.dot(tangent);
    reading.dilation = relative_displacement.dot(normal);
    ContactSums sums;
    for (const Contact& contact : state.contacts.contacts) {
        if (std::minmax(contact.corner_block, contact.edge_block) != std::minmax(block, other)) continue;
        if (std::abs(cross(contact.normal, normal)) > parallel_tolerance) continue;
        sums.add(contact);
        const JointLaw& law = model.joint_material_at(contact.joint_material).law;
        if (contact.state != ContactState::open && !has_segment_history(law))
            sums.strength += smaller(strength(law, contact.history, contact.normal_force, contact.length));
    }
    if (sums.closed == 0) return reading;
    const JointLaw& law = model.joint_material_at(sums.most_loaded->joint_material).law;
    if (has_segment_history(law))
        sums.strength = smaller(strength(law, sums.most_loaded->history, sums.normal_force, sums.length));
    const double per_length = sums.length > 0 ? 1 / sums.length : 0;
    reading.shear_stress = -sums.shear_force * per_length;
    reading.normal_stress = sums.normal_force * per_length;
    const double whole = joint_length(model, joint);
    reading.shear_stress_over_joint = -sums.shear_force / whole;
    reading.normal_stress_over_joint = sums.normal_force / whole;
    reading.strength = sums.strength / model.strength_reduction * per_length;
    reading.slip = -sums.slip / sums.closed;
    reading.state = sums.slides ? ContactState::sliding : ContactState::locked;
    reading.record = record(law, sums.most_loaded->history);
    return reading;
}

}  // namespace rockslope::dda
