#include "dda/terms/springs.hpp"

#include <algorithm>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

/// Attaches a spring to a point of block `a` and a point of block `b`.
BlockPair attach(const RowMap& rows, const MidStep& mid, BlockIndex a, const Vec2& point_on_a, BlockIndex b,
                 const Vec2& point_on_b) {
    return {rows.row_of[a], rows.row_of[b], point_on_a - mid.centroid[a], point_on_b - mid.centroid[b]};
}

/// The measure of Eq. (20) along `direction`, with the part of it that the prescribed motion of blocks
/// without unknowns gives.
RelativeMeasure relative_measure(const BlockPair& pair, BlockSpan<const Vec6> prescribed,
                                 const Vec2& direction, BlockIndex a, BlockIndex b) {
    RelativeMeasure relative{direction, 0};
    if (!pair.first.exists()) relative.prescribed += pair.gradient_first(relative).dot(prescribed[a]);
    if (!pair.second.exists()) relative.prescribed += pair.gradient_second(relative).dot(prescribed[b]);
    return relative;
}

}  // namespace

void BlockPair::add_force(const RelativeMeasure& relative, double force, RowSpan<Vec6> load) const {
    if (first.exists()) load[first] += force * gradient_first(relative);
    if (second.exists()) load[second] += force * gradient_second(relative);
}

PerContact<ContactSprings> contact_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                           BlockSpan<const Vec6> prescribed,
                                           ContactSpan<const Contact> contacts, const ThreadPool& pool) {
    PerContact<ContactSprings> springs(contacts.size());
    pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const Contact& contact = contacts[k];
            const Vec2& point = mid.vertices[contact.corner];
            const Vec2& first = mid.vertices[start_of(contact.edge)];
            const Vec2& second = mid.vertices[model.topology.end_of(contact.edge)];
            const CornerEdgeGeometry geometry = corner_edge_geometry(point, first, second);
            // The force acts half-way between the corner and the face it lies on, Eq. (19): the same place
            // when corner and edge exchange roles.
            const Vec2 contact_point = point - geometry.gap / 2 * geometry.normal;
            ContactSprings& spring = springs[k];
            spring.rows =
                attach(rows, mid, contact.corner_block, contact_point, contact.edge_block, contact_point);
            const auto measure = [&](const Vec2& direction) {
                return relative_measure(spring.rows, prescribed, direction, contact.corner_block,
                                        contact.edge_block);
            };
            spring.normal = measure(geometry.normal);
            spring.shear = measure(geometry.tangent);
            spring.normal_law = normal_spring(model, contact);
            spring.normal_stiffness = spring.normal_law.tangent(contact.normal_force);
            spring.shear_stiffness = shear_stiffness(model, contact);
        }
    });
    return springs;
}

std::vector<BoltSpring> bolt_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                     BlockSpan<const Vec6> prescribed) {
    std::vector<BoltSpring> springs;
    for (const BoltSpec& bolt : model.bolts) {
        const MaterialPoint& first = model.material_points[bolt.first];
        const MaterialPoint& second = model.material_points[bolt.second];
        const Vec2& from = mid.points[bolt.first];
        const Vec2& to = mid.points[bolt.second];
        BoltSpring spring;
        spring.rows = attach(rows, mid, second.block, to, first.block, from);
        spring.elongation =
            relative_measure(spring.rows, prescribed, (to - from).normalized(), second.block, first.block);
        spring.stiffness = bolt.axial_stiffness / (second.position - first.position).norm();
        springs.push_back(spring);
    }
    return springs;
}

double max_spring_stiffness(ContactSpan<const ContactSprings> springs) {
    double max_stiffness = 0;
    for (const ContactSprings& s : springs)
        max_stiffness = std::max({max_stiffness, s.normal_stiffness, s.shear_stiffness});
    return max_stiffness;
}

}  // namespace rockslope::dda
