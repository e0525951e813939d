#include "dda/terms/springs.hpp"

#include <algorithm>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"

namespace dda {

namespace {

/// The displacement of `point` along `direction` as block `a` carries it, less that as block `b` carries it.
Relative relative_displacement(const RowMap& rows, const MidStep& mid, std::span<const Vec6> prescribed,
                               const Vec2& direction, int a, const Vec2& point_on_a, int b,
                               const Vec2& point_on_b) {
    Relative relative;
    const auto ia = static_cast<std::size_t>(a);
    const auto ib = static_cast<std::size_t>(b);
    relative.first = project(direction, point_on_a - mid.centroid[ia]);
    relative.second = -project(direction, point_on_b - mid.centroid[ib]);
    if (rows.row_of[ia] < 0) relative.known += relative.first.dot(prescribed[ia]);
    if (rows.row_of[ib] < 0) relative.known += relative.second.dot(prescribed[ib]);
    return relative;
}

}  // namespace

double PairRows::measure(const Relative& relative, std::span<const Vec6> d) const {
    double sum = relative.known;
    if (first >= 0) sum += relative.first.dot(d[static_cast<std::size_t>(first)]);
    if (second >= 0) sum += relative.second.dot(d[static_cast<std::size_t>(second)]);
    return sum;
}

void PairRows::add_force(const Relative& relative, double force, std::span<Vec6> load) const {
    if (first >= 0) load[static_cast<std::size_t>(first)] += force * relative.first;
    if (second >= 0) load[static_cast<std::size_t>(second)] += force * relative.second;
}

std::vector<ContactSprings> contact_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                            std::span<const Vec6> prescribed,
                                            std::span<const Contact> contacts, const Crew& crew) {
    std::vector<ContactSprings> springs(contacts.size());
    crew.for_ranges(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Contact& contact = contacts[k];
            const Vec2& point = mid.vertices[static_cast<std::size_t>(contact.corner)];
            const Vec2& first = mid.vertices[static_cast<std::size_t>(contact.edge)];
            const Vec2& second = mid.vertices[static_cast<std::size_t>(
                model.topology.next[static_cast<std::size_t>(contact.edge)])];
            const CornerEdgeGeometry geometry = corner_edge_geometry(point, first, second);
            // The force acts half-way between the corner and the face it lies on: the same place when corner
            // and edge exchange roles.
            const Vec2 meeting = point - geometry.gap / 2 * geometry.normal;
            const auto measure = [&](const Vec2& direction) {
                return relative_displacement(rows, mid, prescribed, direction, contact.corner_block, meeting,
                                             contact.edge_block, meeting);
            };
            ContactSprings& spring = springs[k];
            spring.rows = {rows.row_of[static_cast<std::size_t>(contact.corner_block)],
                           rows.row_of[static_cast<std::size_t>(contact.edge_block)]};
            spring.normal = measure(geometry.normal);
            spring.shear = measure(geometry.tangent);
            spring.closing = normal_spring(model, contact);
            spring.normal_stiffness = spring.closing.tangent(contact.normal_force);
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
        spring.rows = {rows.row_of[static_cast<std::size_t>(second.block)],
                       rows.row_of[static_cast<std::size_t>(first.block)]};
        spring.elongation = relative_displacement(rows, mid, prescribed, (to - from).normalized(),
                                                  second.block, to, first.block, from);
        spring.stiffness = bolt.axial_stiffness / (second.position - first.position).norm();
        springs.push_back(spring);
    }
    return springs;
}

double stiffest_spring(std::span<const ContactSprings> springs) {
    double stiffest = 0;
    for (const ContactSprings& s : springs)
        stiffest = std::max({stiffest, s.normal_stiffness, s.shear_stiffness});
    return stiffest;
}

}  // namespace dda
