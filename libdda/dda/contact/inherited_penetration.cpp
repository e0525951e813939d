#include "dda/contact/inherited_penetration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

/// Cosine of the angle between normals up to which two lines are one.
const double min_cosine_parallel = std::sqrt(1 - parallel_tolerance * parallel_tolerance);
/// Cosine of the angle up to which a face of a corner lies over the line that the corner slides along.
const double min_cosine_overlying = std::sqrt(.5);

}  // namespace

std::optional<double> penetration_accounted_for(const Topology& topology, std::span<const Vec2> vertices,
                                                const Contact& contact) {
    if (contact.state != ContactState::open) return -contact.gap;
    if (contact.inhibited || contact.inherited_penetration == 0) return std::nullopt;
    const auto next = [&](int corner) { return topology.next[static_cast<std::size_t>(corner)]; };
    const auto at = [&](int corner) -> const Vec2& { return vertices[static_cast<std::size_t>(corner)]; };
    const auto geometry = [&](int corner, int edge) {
        return corner_edge_geometry(at(corner), at(edge), at(next(edge)));
    };
    const auto is_within_inherited = [&](const CornerEdgeGeometry& g) {
        return g.end_margin() >= -end_tolerance * g.length && g.gap < 0 &&
               -g.gap <= 2 * contact.inherited_penetration;
    };
    const CornerEdgeGeometry own = geometry(contact.corner, contact.edge);
    if (is_within_inherited(own)) return -own.gap;
    const int end = own.along < own.length / 2 ? contact.edge : next(contact.edge);
    const int arriving = topology.previous[static_cast<std::size_t>(contact.corner)];
    for (const int face : {contact.corner, arriving}) {
        const CornerEdgeGeometry reversed = geometry(end, face);
        if (is_within_inherited(reversed) && reversed.normal.dot(own.normal) <= -min_cosine_overlying)
            return -reversed.gap;
    }
    return std::nullopt;
}

struct InheritedPenetrations::Found {
    std::vector<Entry> entries;
    std::vector<int> corners;  ///< of each
};

InheritedPenetrations::Found InheritedPenetrations::find(const Topology& topology,
                                                         std::span<const Vec2> vertices,
                                                         std::span<const Contact> contacts,
                                                         double search_radius) {
    const auto at = [&](int corner) -> const Vec2& { return vertices[static_cast<std::size_t>(corner)]; };
    Found found;
    found.entries.reserve(2 * contacts.size());
    found.corners.reserve(2 * contacts.size());
    const auto add = [&](int corner, const Entry& entry) {
        found.corners.push_back(corner);
        found.entries.push_back(entry);
    };
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& contact = contacts[k];
        const std::optional<double> accounted = penetration_accounted_for(topology, vertices, contact);
        // Faces that shearing has moved together let corners in that far, whether or not they bear.
        const double contracted = contact.inhibited ? 0 : std::max(-contact.dilation, 0.0);
        if (!accounted && contracted == 0) continue;
        const int end = topology.next[static_cast<std::size_t>(contact.edge)];
        const double depth = contracted + accounted.value_or(0);
        const double stress_free_gap = contact.state == ContactState::open ? 0 : contact.stress_free_gap;
        const double spring_depth = depth + stress_free_gap;
        const int index = static_cast<int>(k);
        add(contact.corner, {index, contact.edge_block, depth, spring_depth});
        for (const int other : {contact.edge, end}) {
            if ((at(other) - at(contact.corner)).norm() <= search_radius)
                add(other, {index, contact.corner_block, depth, spring_depth});
        }
    }
    return found;
}

InheritedPenetrations::InheritedPenetrations(std::span<const Contact> contacts, int corners, Found found)
    : contacts_(contacts), entries_(std::move(found.entries)), by_corner_(corners, found.corners) {}

InheritedPenetrations::InheritedPenetrations(const Topology& topology, std::span<const Vec2> vertices,
                                             std::span<const Contact> contacts, double search_radius)
    : InheritedPenetrations(contacts, topology.corner_count(),
                            find(topology, vertices, contacts, search_radius)) {}

double InheritedPenetrations::along(int corner, const Vec2& normal) const {
    double deepest = 0;
    for (const int k : by_corner_.of(corner)) {
        if (normal_of(entry(k)).dot(normal) >= min_cosine_parallel)
            deepest = std::max(deepest, entry(k).depth);
    }
    return deepest;
}

double InheritedPenetrations::in_block(int corner, int block) const {
    double deepest = 0;
    for (const int k : by_corner_.of(corner)) {
        if (entry(k).block == block) deepest = std::max({deepest, entry(k).depth, entry(k).spring_depth});
    }
    return deepest;
}

}  // namespace rockslope::dda
