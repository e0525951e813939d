#include "dda/contact/detect.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "dda/contact/candidates.hpp"

namespace dda {

namespace {

auto sort_key(const Contact& c) {
    return std::tuple(c.corner_block, c.edge_block, c.corner, c.edge);
}

/// A contact in the making: what selection among a group needs besides the contact.
struct Entry {
    Contact contact;
    double inside = 0;   ///< m, projection inside the ends
    int partner = -1;    ///< the edge's end that the corner is near, or -1
    bool holds = false;  ///< it carried force at the end of the last step, and its corner is on its edge
};

/// How far past its edge's end a corner may be and still be on it, as a share of the edge: the ends of two
/// equal faces shift by elastic strains from step to step, and a contact that changed roles with each of them
/// would never come to rest.
constexpr double end_slack = 1e-6;

/// How far the gaps of two nearly parallel lines at a pair of corners may differ and still be those of one
/// line, as a share of the reach.
constexpr double same_line = 1e-6;

class Detector {
  public:
    Detector(const Model& model, std::span<const Vec2> vertices, double reach,
             std::span<const Contact> previous, std::span<const CornerEdge> entering)
        : model_(model),
          topology_(model.topology),
          vertices_(vertices),
          reach_(reach),
          previous_(previous),
          entering_(entering) {}

    /// Fills the entry for a candidate. @return whether it is a contact at all.
    bool examine(const CornerEdge& candidate, Entry& entry) const {
        const auto [corner, edge] = candidate;
        const Vec2& vertex = at(corner);
        const CornerEdgeGeometry geometry = corner_edge_geometry(vertex, at(edge), at(next(edge)));
        Contact& contact = entry.contact;
        contact.corner = corner;
        contact.edge = edge;
        contact.corner_block = topology_.block_of[index(corner)];
        contact.edge_block = topology_.block_of[index(edge)];
        const Contact* old = find_previous(contact);
        const bool enters = std::binary_search(entering_.begin(), entering_.end(), candidate);
        if (!enters) {
            if (old == nullptr && distance_to_segment(vertex, at(edge), at(next(edge))) > reach_)
                return false;
            // What bears force keeps the corner out until it opens or slides off the edge.
            const bool bears = old != nullptr && old->state != ContactState::open &&
                               geometry.inside() >= -end_slack * geometry.length;
            if (!bears && !faces_outwards(topology_, vertices_, corner, geometry.normal)) return false;
        }

        contact.point = vertex;
        contact.normal = geometry.normal;
        contact.tangent = geometry.tangent;
        contact.gap = geometry.gap;
        contact.joint_material = joint_material_of(corner, edge);
        contact.joint = topology_.joint[index(edge)];
        entry.inside = geometry.inside();
        entry.holds = old != nullptr && old->state != ContactState::open &&
                      entry.inside >= -end_slack * geometry.length;
        const int end = geometry.along < geometry.length / 2 ? edge : next(edge);
        entry.partner = !enters && (vertex - at(end)).norm() <= reach_ && !is_reflex(end) ? end : -1;
        return true;
    }

    /// The contacts of one pair of corners: one for each distinct line, with a common group.
    void resolve_group(std::span<Entry> members, int group, std::vector<Contact>& out) const {
        const std::size_t first = out.size();
        std::vector<const Entry*> lines;
        for (const Entry& entry : members) {
            const auto same = std::find_if(lines.begin(), lines.end(), [&](const Entry* line) {
                return std::abs(cross(line->contact.normal, entry.contact.normal)) < parallel_tolerance;
            });
            if (same == lines.end()) {
                lines.push_back(&entry);
            } else if (better(entry, **same)) {
                *same = &entry;
            }
        }
        for (const Entry* line : lines) {
            Contact contact = line->contact;
            contact.group = lines.size() > 1 ? group : -1;
            contact.length = shared_length(contact.corner, line->partner, contact.tangent);
            contact.kind = contact.length > 0 ? ContactKind::edge_edge : ContactKind::vertex_vertex;
            out.push_back(contact);
        }
        keep_what_carries(lines, std::span(out).subspan(first));
    }

    void resolve_single(const Entry& entry, std::vector<Contact>& out) const {
        Contact contact = entry.contact;
        for (const int a : {contact.corner, previous(contact.corner)})
            contact.length += half_overlap(a, contact.edge);
        contact.kind = contact.length > 0 ? ContactKind::edge_edge : ContactKind::vertex_edge;
        out.push_back(contact);
    }

  private:
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    const Vec2& at(int corner) const { return vertices_[index(corner)]; }
    int next(int corner) const { return topology_.next[index(corner)]; }
    int previous(int corner) const { return topology_.previous[index(corner)]; }

    const Contact* find_previous(const Contact& contact) const {
        const auto found =
            std::lower_bound(previous_.begin(), previous_.end(), contact,
                             [](const Contact& a, const Contact& b) { return sort_key(a) < sort_key(b); });
        return found != previous_.end() && sort_key(*found) == sort_key(contact) ? &*found : nullptr;
    }

    bool is_reflex(int corner) const {
        const Vec2 arriving = at(corner) - at(previous(corner));
        const Vec2 leaving = at(next(corner)) - at(corner);
        return cross(arriving, leaving) < -parallel_tolerance * arriving.norm() * leaving.norm();
    }

    /// The edge's material; on a free face that of the face of the corner that lies on it, and the model's
    /// default last.
    int joint_material_of(int corner, int edge) const {
        for (const int e : {edge, corner, previous(corner)}) {
            const int material = topology_.joint_material[index(e)];
            if (material >= 0) return material;
        }
        return model_.default_joint_material;
    }

    /// Whether `a` is to stand for its line rather than `b`: the one that holds; then the one with the larger
    /// gap, since the blocks are apart as long as one of them is open; where they are the same line, the one
    /// whose corner projects farther inside; a tie, as where two corners coincide, goes to the earlier.
    bool better(const Entry& a, const Entry& b) const {
        if (a.holds != b.holds) return a.holds;
        const double ahead = a.contact.gap - b.contact.gap;
        if (std::abs(ahead) > same_line * reach_) return ahead > 0;
        return a.inside > b.inside + 1e-9 * reach_;
    }

    /// A line that holds keeps the group, however deep: the others cannot close.
    static void keep_what_carries(std::span<const Entry* const> lines, std::span<Contact> contacts) {
        const auto holder =
            std::find_if(lines.begin(), lines.end(), [](const Entry* line) { return line->holds; });
        if (holder == lines.end()) return;
        for (std::size_t k = 0; k < lines.size(); ++k) contacts[k].held_back = lines[k] != *holder;
    }

    /// Half the length over which two faces lie on each other, m: zero unless they run against each other.
    double half_overlap(int a, int b) const {
        const Vec2 along = at(next(b)) - at(b);
        const double length = along.norm();
        const Vec2 face = at(next(a)) - at(a);
        if (along.dot(face) >= 0 || std::abs(cross(along, face)) > parallel_tolerance * length * face.norm())
            return 0;
        const double from = std::max(0.0, (at(next(a)) - at(b)).dot(along) / length);
        const double to = std::min(length, (at(a) - at(b)).dot(along) / length);
        return std::max(0.0, to - from) / 2;
    }

    /// The half overlaps of all faces at two neighbouring corners that run along `tangent`.
    double shared_length(int corner, int partner, const Vec2& tangent) const {
        double sum = 0;
        for (const int a : {corner, previous(corner)}) {
            const Vec2 face = at(next(a)) - at(a);
            if (std::abs(cross(face, tangent)) > parallel_tolerance * face.norm()) continue;
            for (const int b : {partner, previous(partner)}) sum += half_overlap(a, b);
        }
        return sum;
    }

    const Model& model_;
    const Topology& topology_;
    std::span<const Vec2> vertices_;
    double reach_;
    std::span<const Contact> previous_;
    std::span<const CornerEdge> entering_;
};

}  // namespace

CornerEdgeGeometry corner_edge_geometry(const Vec2& corner, const Vec2& first, const Vec2& second) {
    CornerEdgeGeometry geometry;
    const Vec2 edge = second - first;
    geometry.length = edge.norm();
    geometry.tangent = edge / geometry.length;
    geometry.normal = -perpendicular(geometry.tangent);
    geometry.gap = (corner - first).dot(geometry.normal);
    geometry.along = (corner - first).dot(geometry.tangent);
    return geometry;
}

bool faces_outwards(const Topology& topology, std::span<const Vec2> vertices, int corner,
                    const Vec2& normal) {
    const auto k = static_cast<std::size_t>(corner);
    const auto at = [&](int c) { return vertices[static_cast<std::size_t>(c)]; };
    const Vec2 leaving = (at(topology.next[k]) - at(corner)).normalized();
    const Vec2 arriving = (at(topology.previous[k]) - at(corner)).normalized();
    if (leaving.dot(normal) < -parallel_tolerance || arriving.dot(normal) < -parallel_tolerance) return false;
    return perpendicular(leaving - arriving).dot(normal) > 0 ||
           (leaving + arriving).dot(normal) > parallel_tolerance;
}

std::vector<Contact> detect_contacts(const Model& model, std::span<const Vec2> vertices,
                                     std::span<const CornerEdge> candidates, double reach,
                                     std::span<const Contact> previous, std::span<const CornerEdge> entering,
                                     const Crew& crew) {
    const Detector detector(model, vertices, reach, previous, entering);
    std::vector<Entry> examined(candidates.size());
    std::vector<char> accepted(candidates.size(), 0);
    crew.for_ranges(candidates.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            accepted[k] = detector.examine(candidates[k], examined[k]) ? 1 : 0;
    });

    std::vector<Contact> contacts;
    std::vector<std::pair<std::pair<int, int>, std::size_t>> grouped;  // (corner pair, entry)
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        if (accepted[k] == 0) continue;
        if (examined[k].partner < 0) {
            detector.resolve_single(examined[k], contacts);
        } else {
            grouped.push_back({std::minmax(examined[k].contact.corner, examined[k].partner), k});
        }
    }
    std::sort(grouped.begin(), grouped.end());
    std::vector<Entry> members;
    int group = 0;
    for (std::size_t k = 0; k < grouped.size(); ++group) {
        members.clear();
        const auto corners = grouped[k].first;
        for (; k < grouped.size() && grouped[k].first == corners; ++k)
            members.push_back(examined[grouped[k].second]);
        detector.resolve_group(members, group, contacts);
    }
    std::sort(contacts.begin(), contacts.end(),
              [](const Contact& a, const Contact& b) { return sort_key(a) < sort_key(b); });
    return contacts;
}

}  // namespace dda
