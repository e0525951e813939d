#include "dda/terms/springs.hpp"

#include <algorithm>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

/// The two blocks' unknowns, where they have any, and a point of each.
BlockPair attach(const RowMap& rows, const MidStep& mid, int a, const Vec2& point_on_a, int b,
                 const Vec2& point_on_b) {
    const auto ia = static_cast<std::size_t>(a);
    const auto ib = static_cast<std::size_t>(b);
    return {rows.row_of[ia], rows.row_of[ib], point_on_a - mid.centroid[ia], point_on_b - mid.centroid[ib]};
}

/// The displacement of the point of block `a` along `direction`, less that of the point of block `b`.
RelativeMeasure relative_measure(const BlockPair& pair, std::span<const Vec6> prescribed,
                                 const Vec2& direction, int a, int b) {
    RelativeMeasure relative{direction, 0};
    if (pair.first < 0)
        relative.prescribed += pair.gradient_first(relative).dot(prescribed[static_cast<std::size_t>(a)]);
    if (pair.second < 0)
        relative.prescribed += pair.gradient_second(relative).dot(prescribed[static_cast<std::size_t>(b)]);
    return relative;
}

}  // namespace

void BlockPair::add_force(const RelativeMeasure& relative, double force, std::span<Vec6> load) const {
    if (first >= 0) load[static_cast<std::size_t>(first)] += force * gradient_first(relative);
    if (second >= 0) load[static_cast<std::size_t>(second)] += force * gradient_second(relative);
}

std::vector<ContactSprings> contact_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                            std::span<const Vec6> prescribed,
                                            std::span<const Contact> contacts, const ThreadPool& pool) {
    std::vector<ContactSprings> springs(contacts.size());
    pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Contact& contact = contacts[k];
            const Vec2& point = mid.vertices[static_cast<std::size_t>(contact.corner)];
            const Vec2& first = mid.vertices[static_cast<std::size_t>(contact.edge)];
            const Vec2& second = mid.vertices[static_cast<std::size_t>(
                model.topology.next[static_cast<std::size_t>(contact.edge)])];
            const CornerEdgeGeometry geometry = corner_edge_geometry(point, first, second);
            // The force acts half-way between the corner and the face it lies on: the same place when corner
            // and edge exchange roles.
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
                                     std::span<const Vec6> prescribed) {
    std::vector<BoltSpring> springs;
    for (const BoltSpec& bolt : model.bolts) {
        const MaterialPoint& first = model.material_points[static_cast<std::size_t>(bolt.first)];
        const MaterialPoint& second = model.material_points[static_cast<std::size_t>(bolt.second)];
        const Vec2& from = mid.points[static_cast<std::size_t>(bolt.first)];
        const Vec2& to = mid.points[static_cast<std::size_t>(bolt.second)];
        BoltSpring spring;
        spring.rows = attach(rows, mid, second.block, to, first.block, from);
        spring.elongation =
            relative_measure(spring.rows, prescribed, (to - from).normalized(), second.block, first.block);
        spring.stiffness = bolt.axial_stiffness / (second.position - first.position).norm();
        springs.push_back(spring);
    }
    return springs;
}

double max_spring_stiffness(std::span<const ContactSprings> springs) {
    double max_stiffness = 0;
    for (const ContactSprings& s : springs)
        max_stiffness = std::max({max_stiffness, s.normal_stiffness, s.shear_stiffness});
    return max_stiffness;
}

}  // namespace rockslope::dda
