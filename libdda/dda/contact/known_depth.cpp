#include "dda/contact/known_depth.hpp"

#include <algorithm>
#include <cmath>

#include "dda/contact/detect.hpp"

namespace dda {

namespace {

/// Cosine of the angle between normals up to which two lines are one.
const double facing = std::sqrt(1 - parallel_tolerance * parallel_tolerance);

}  // namespace

bool stands_for_its_depth(const Topology& topology, std::span<const Vec2> vertices, const Contact& contact) {
    if (contact.state != ContactState::open) return true;
    if (contact.held_back || contact.known_depth == 0) return false;
    const auto next = [&](int corner) { return topology.next[static_cast<std::size_t>(corner)]; };
    const auto at = [&](int corner) -> const Vec2& { return vertices[static_cast<std::size_t>(corner)]; };
    const auto geometry = [&](int corner, int edge) {
        return corner_edge_geometry(at(corner), at(edge), at(next(edge)));
    };
    const auto is_in_as_known = [&](const CornerEdgeGeometry& g) {
        return g.inside() >= -end_slack * g.length && g.gap < 0 && -g.gap <= 2 * contact.known_depth;
    };
    const CornerEdgeGeometry own = geometry(contact.corner, contact.edge);
    if (is_in_as_known(own)) return true;
    const int end = own.along < own.length / 2 ? contact.edge : next(contact.edge);
    const int arriving = topology.previous[static_cast<std::size_t>(contact.corner)];
    const auto takes_its_place = [&](int face) {
        const CornerEdgeGeometry turned = geometry(end, face);
        return is_in_as_known(turned) && turned.normal.dot(own.normal) <= -facing;
    };
    return takes_its_place(contact.corner) || takes_its_place(arriving);
}

KnownDepths::KnownDepths(const Topology& topology, std::span<const Vec2> vertices,
                         std::span<const Contact> contacts, double reach) {
    const auto at = [&](int corner) -> const Vec2& { return vertices[static_cast<std::size_t>(corner)]; };
    for (const Contact& contact : contacts) {
        if (!stands_for_its_depth(topology, vertices, contact)) continue;
        const int end = topology.next[static_cast<std::size_t>(contact.edge)];
        const double contracted = std::max(-contact.dilation, 0.0);
        const double depth = contracted - contact.gap;
        const double spring_depth = contracted + contact.rest_gap - contact.gap;
        entries_.push_back({contact.corner, contact.edge_block, contact.normal, depth, spring_depth});
        for (const int other : {contact.edge, end}) {
            if ((at(other) - at(contact.corner)).norm() <= reach)
                entries_.push_back({other, contact.corner_block, -contact.normal, depth, spring_depth});
        }
    }
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.corner < b.corner; });
}

std::span<const KnownDepths::Entry> KnownDepths::entries_of(int corner) const {
    const auto first = std::partition_point(entries_.begin(), entries_.end(),
                                            [&](const Entry& entry) { return entry.corner < corner; });
    const auto last =
        std::find_if(first, entries_.end(), [&](const Entry& entry) { return entry.corner != corner; });
    return {first, last};
}

double KnownDepths::along(int corner, const Vec2& normal) const {
    double deepest = 0;
    for (const Entry& entry : entries_of(corner)) {
        if (entry.normal.dot(normal) >= facing) deepest = std::max(deepest, entry.depth);
    }
    return deepest;
}

double KnownDepths::in_block(int corner, int block) const {
    double deepest = 0;
    for (const Entry& entry : entries_of(corner)) {
        if (entry.block == block) deepest = std::max({deepest, entry.depth, entry.spring_depth});
    }
    return deepest;
}

}  // namespace dda
