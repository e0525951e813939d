#include "dda/contact/inherited_penetration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/parallel_parts.hpp"
#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

/// Cosine of the largest angle between the normals of two parallel lines.
const double min_cosine_parallel = std::sqrt(1 - parallel_tolerance * parallel_tolerance);
/// Cosine of the largest angle at which an edge of a sliding corner lies over the edge that it slid off: 45
/// degrees.
const double min_cosine_overlying = std::sqrt(.5);

/// How much deeper the corner `other` of a contact's edge may be in the faces at the contact's corner than
/// the contact, m: where a face and the edge overlap by too little for two contacts, the overlap times the
/// sine of their angle.
double lean(const Topology& topology, CornerSpan<const Vec2> vertices, const Contact& contact,
            CornerIndex other) {
    const double overlap = (vertices[other] - vertices[contact.corner]).squaredNorm();
    const Vec2 edge = vertices[topology.end_of(contact.edge)] - vertices[start_of(contact.edge)];
    double largest = 0;
    for (const CornerIndex start : {contact.corner, topology.previous[contact.corner]}) {
        const Vec2 face = vertices[topology.next[start]] - vertices[start];
        const double longer = std::max(face.squaredNorm(), edge.squaredNorm());
        if (overlap > min_overlap_ratio * min_overlap_ratio * longer || face.dot(edge) >= 0) continue;
        const double sine = std::abs(cross(face, edge)) / (face.norm() * edge.norm());
        if (sine < parallel_tolerance) largest = std::max(largest, std::sqrt(overlap) * sine);
    }
    return largest;
}

}  // namespace

std::optional<double> penetration_accounted_for(const Topology& topology, CornerSpan<const Vec2> vertices,
                                                const Contact& contact) {
    if (contact.state != ContactState::open) return -contact.gap;
    if (contact.inhibited || contact.inherited_penetration == 0) return std::nullopt;
    const auto geometry = [&](CornerIndex corner, EdgeIndex edge) {
        return corner_edge_geometry(vertices[corner], vertices[start_of(edge)],
                                    vertices[topology.end_of(edge)]);
    };
    // Inside the block by at most twice the inherited penetration, on the edge.
    const auto is_within_inherited = [&](const CornerEdgeGeometry& g) {
        return g.end_margin() >= -end_tolerance * g.length && g.gap < 0 &&
               -g.gap <= 2 * contact.inherited_penetration;
    };
    const CornerEdgeGeometry own = geometry(contact.corner, contact.edge);
    if (is_within_inherited(own)) return -own.gap;
    // The corner is past the end of the edge: test the end against both edges of the corner.
    const CornerIndex end =
        own.along < own.length / 2 ? start_of(contact.edge) : topology.end_of(contact.edge);
    const EdgeIndex arriving = edge_from(topology.previous[contact.corner]);
    for (const EdgeIndex face : {edge_from(contact.corner), arriving}) {
        const CornerEdgeGeometry reversed = geometry(end, face);
        if (is_within_inherited(reversed) && reversed.normal.dot(own.normal) <= -min_cosine_overlying)
            return -reversed.gap;
    }
    return std::nullopt;
}

struct InheritedPenetrations::Found {
    std::vector<Entry> entries;
    std::vector<CornerIndex> corners;  ///< of each entry
};

InheritedPenetrations::Found InheritedPenetrations::find(const Topology& topology,
                                                         CornerSpan<const Vec2> vertices,
                                                         std::span<const Contact> contacts,
                                                         double search_radius) {
    Found found;
    found.entries.reserve(2 * contacts.size());
    found.corners.reserve(2 * contacts.size());
    const auto add = [&](CornerIndex corner, const Entry& entry) {
        found.corners.push_back(corner);
        found.entries.push_back(entry);
    };
    for (const Contact& contact : contacts) {
        const std::optional<double> accounted = penetration_accounted_for(topology, vertices, contact);
        // A contracted joint lets corners in by its contraction, in contact or not, and a contact that opened
        // inside the rock by its stress-free gap. Of an entrance line the gap says nothing.
        const bool opened_inside = contact.state == ContactState::open && contact.group < 0;
        const double free_gap = contact.dilation + (opened_inside ? contact.stress_free_gap : 0);
        const double let_in = contact.inhibited ? 0 : std::max(-free_gap, 0.0);
        const double depth = let_in + accounted.value_or(0);
        for (const CornerIndex other : {start_of(contact.edge), topology.end_of(contact.edge)}) {
            const double deeper = contact.inhibited ? 0 : lean(topology, vertices, contact, other);
            if (deeper > 0) add(other, {contact.corner_block, -contact.normal, 0, depth, deeper});
        }
        if (!accounted && let_in == 0) continue;
        const double stress_free_gap = contact.state == ContactState::open ? 0 : contact.stress_free_gap;
        const double spring_depth = depth + stress_free_gap;
        add(contact.corner, {contact.edge_block, contact.normal, depth, spring_depth});
        // A neighbour so near that the penetration turns their edge beyond the slack of Eq. (27) has no
        // contact.
        for (const CornerIndex neighbour :
             {topology.previous[contact.corner], topology.next[contact.corner]}) {
            if (parallel_tolerance * (vertices[neighbour] - vertices[contact.corner]).norm() <= depth)
                add(neighbour, {contact.edge_block, contact.normal, depth, spring_depth});
        }
        for (const CornerIndex other : {start_of(contact.edge), topology.end_of(contact.edge)}) {
            if ((vertices[other] - vertices[contact.corner]).norm() <= search_radius)
                add(other, {contact.corner_block, -contact.normal, depth, spring_depth});
        }
    }
    return found;
}

InheritedPenetrations::Found InheritedPenetrations::find(const Topology& topology,
                                                         CornerSpan<const Vec2> vertices,
                                                         std::span<const Contact> contacts,
                                                         double search_radius, const ThreadPool& pool) {
    std::vector<Found> parts = parallel_parts(pool, contacts.size(), [&](std::size_t begin, std::size_t end) {
        return find(topology, vertices, contacts.subspan(begin, end - begin), search_radius);
    });
    Found& all = parts.front();
    for (const Found& more : std::span(parts).subspan(1)) {
        append(all.entries, more.entries);
        append(all.corners, more.corners);
    }
    return std::move(all);
}

InheritedPenetrations::InheritedPenetrations(std::size_t corners, Found found)
    : entries_(std::move(found.entries)), by_corner_(corners, found.corners) {}

InheritedPenetrations::InheritedPenetrations(const Topology& topology, CornerSpan<const Vec2> vertices,
                                             ContactSpan<const Contact> contacts, double search_radius,
                                             const ThreadPool& pool)
    : InheritedPenetrations(topology.corner_count(),
                            find(topology, vertices, contacts, search_radius, pool)) {}

double InheritedPenetrations::along(CornerIndex corner, const Vec2& normal) const {
    double deepest = 0;
    for (const std::uint32_t k : by_corner_.of(corner)) {
        if (entry(k).normal.dot(normal) >= min_cosine_parallel) deepest = std::max(deepest, entry(k).depth);
    }
    return deepest;
}

double InheritedPenetrations::in_block(CornerIndex corner, BlockIndex block) const {
    double deepest = 0;
    for (const std::uint32_t k : by_corner_.of(corner)) {
        if (entry(k).block == block) deepest = std::max({deepest, entry(k).depth, entry(k).spring_depth});
    }
    return deepest;
}

double InheritedPenetrations::lean_in_block(CornerIndex corner, BlockIndex block) const {
    double largest = 0;
    for (const std::uint32_t k : by_corner_.of(corner)) {
        if (entry(k).block == block) largest = std::max(largest, entry(k).lean);
    }
    return largest;
}

}  // namespace rockslope::dda
