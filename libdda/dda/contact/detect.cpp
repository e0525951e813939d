#include "dda/contact/detect.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dda/contact/candidates.hpp"
#include "dda/contact/inherited_penetration.hpp"
#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

namespace {

/// A contact in the making: what is found out of a candidate before it is known which of them become
/// contacts.
struct ContactCandidate {
    CornerEdge pair;
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    double gap = 0;                    ///< m, less the dilation
    double dilation = 0;               ///< m
    double inherited_penetration = 0;  ///< m
    bool inhibited = false;
    double end_margin = 0;    ///< m, projection inside the ends where the corner is expected to go
    int partner_corner = -1;  ///< the edge's end that the corner is near, or -1
    bool carries_force =
        false;  ///< it carried force at the end of the last step, and its corner is on its edge
    bool remains_on_edge = false;  ///< and is expected to stay on it
    bool is_behind = false;        ///< open, and its corner is behind it: it did not come in here
};

/// An entry that becomes a contact.
struct SelectedContact {
    const ContactCandidate* entry = nullptr;
    ContactKind kind = ContactKind::vertex_edge;
    double length = 0;
    int group = -1;
    int line = 0;
    bool inhibited = false;
    int block = 0;  ///< the lower of the two that it is between
};

/// Entries of one pair of corners whose normals are parallel.
struct EntranceLine {
    const ContactCandidate* best = nullptr;
    bool carries_force = false;
};

/// How far two faces must overlap, as a share of the edge, for a second contact to come into being where the
/// other end of the overlap has one: below that, slip to and fro would make and unmake it.
constexpr double min_overlap_ratio = 1e-3;

class ContactDetector {
  public:
    ContactDetector(const Model& model, const DetectionInput& detection)
        : model_(model),
          topology_(model.topology),
          input_(detection),
          inherited_penetrations_(model.topology, input_.vertices, input_.previous, input_.search_radius),
          previous_contacts_(model.topology.corner_count(), corners_of(input_.previous)) {}

    /// Whether a candidate is worth examining: it is within search_radius, or was a contact before.
    bool is_near(const CornerEdge& candidate) const {
        const auto [corner, edge] = candidate;
        return distance_to_segment(at(corner), at(edge), at(next(edge))) <= input_.search_radius ||
               find_previous(candidate) != nullptr || is_forced(candidate);
    }

    /// Fills the entry for a candidate. @return whether it is a contact at all.
    bool evaluate_candidate(const CornerEdge& candidate, ContactCandidate& entry) const {
        const auto [corner, edge] = candidate;
        const Vec2& vertex = at(corner);
        const CornerEdgeGeometry geometry = corner_edge_geometry(vertex, at(edge), at(next(edge)));
        entry.pair = candidate;
        const Contact* old = find_previous(candidate);
        const bool is_forced = this->is_forced(candidate);
        if (!is_forced) {
            // An open contact farther off keeps what it knows, but nothing to close on: it may be off its
            // edge's end, on the line that goes on from there.
            entry.inhibited = (old == nullptr || old->state == ContactState::open) &&
                              distance_to_segment(vertex, at(edge), at(next(edge))) > input_.search_radius;
            if (old == nullptr && entry.inhibited) return false;
            // What bears force keeps the corner out until it opens or slides off the edge.
            const bool bears = old != nullptr && old->state != ContactState::open &&
                               geometry.end_margin() >= -end_tolerance * geometry.length;
            if (!bears && !passes_entrance_angle_test(topology_, input_.vertices, corner, geometry.normal))
                return false;
        }

        entry.normal = geometry.normal;
        entry.tangent = geometry.tangent;
        entry.dilation = old != nullptr ? old->dilation : 0;
        entry.gap = geometry.gap - entry.dilation;
        const int end = geometry.along < geometry.length / 2 ? edge : next(edge);
        const bool closed = old != nullptr && old->state != ContactState::open;
        entry.inherited_penetration = std::max(inherited_penetrations_.along(corner, geometry.normal),
                                               inherited_penetrations_.along(end, -geometry.normal));
        entry.end_margin =
            corner_edge_geometry(expected(corner), expected(edge), expected(next(edge))).end_margin();
        entry.carries_force = closed && geometry.end_margin() >= -end_tolerance * geometry.length;
        entry.remains_on_edge = entry.carries_force && entry.end_margin >= -end_tolerance * geometry.length;
        entry.is_behind = !closed && !is_forced &&
                          entry.gap + std::max(entry.dilation, 0.0) <
                              -(input_.depth_tolerance + 2 * entry.inherited_penetration);
        entry.partner_corner =
            !is_forced && (vertex - at(end)).norm() <= input_.search_radius && !is_reflex(end) ? end : -1;
        return true;
    }

    /// Chooses among the entries of one pair of corners, with a common group where they have more than one
    /// line: one for each line, or one for each corner where both are in the other's face.
    /// @param lines work space.
    void select_entrance_lines(std::span<const ContactCandidate* const> members, int group,
                               std::vector<EntranceLine>& lines, std::vector<SelectedContact>& out) const {
        lines.clear();
        for (const ContactCandidate* entry : members) {
            const auto same = std::find_if(lines.begin(), lines.end(), [&](const EntranceLine& line) {
                return std::abs(cross(line.best->normal, entry->normal)) < parallel_tolerance;
            });
            EntranceLine& line = same == lines.end() ? lines.emplace_back() : *same;
            if (line.best == nullptr || is_preferred(*entry, *line.best)) line.best = entry;
            line.carries_force = line.carries_force || entry->carries_force;
        }
        const auto loaded_line = std::find_if(lines.begin(), lines.end(),
                                              [](const EntranceLine& line) { return line.carries_force; });
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const EntranceLine& line = lines[k];
            // A line that holds keeps the group, however deep: the others cannot close.
            const bool inhibited = loaded_line != lines.end() && &*loaded_line != &line;
            const auto select = [&](const ContactCandidate* entry, double length) {
                const ContactKind kind = length > 0 ? ContactKind::edge_edge : ContactKind::vertex_vertex;
                out.push_back({entry, kind, length, lines.size() > 1 ? group : -1, static_cast<int>(k),
                               inhibited, lower_block(*entry)});
            };
            const ContactCandidate* other =
                overlaps(*line.best) ? opposite_end(members, *line.best) : nullptr;
            if (other == nullptr) {
                select(line.best,
                       shared_length(line.best->pair.corner, line.best->partner_corner, line.best->tangent));
            } else {
                select(line.best, overlap_length(line.best->pair));
                select(other, overlap_length(other->pair));
            }
        }
    }

    SelectedContact select_single(const ContactCandidate& entry) const {
        const double length = overlap_length(entry.pair);
        const ContactKind kind = length > 0 ? ContactKind::edge_edge : ContactKind::vertex_edge;
        return {&entry, kind, length, -1, 0, entry.inhibited, lower_block(entry)};
    }

    Contact make_contact(const SelectedContact& selected) const {
        const ContactCandidate& entry = *selected.entry;
        Contact contact;
        contact.corner = entry.pair.corner;
        contact.edge = entry.pair.edge;
        contact.corner_block = topology_.block_of[index(contact.corner)];
        contact.edge_block = topology_.block_of[index(contact.edge)];
        contact.kind = selected.kind;
        contact.joint_material = joint_material_of(contact.corner, contact.edge);
        contact.joint = topology_.joint[index(contact.edge)];
        contact.group = selected.group;
        contact.line = selected.line;
        contact.inhibited = selected.inhibited;
        contact.inherited_penetration = entry.inherited_penetration;
        contact.length = selected.length;
        contact.point = at(contact.corner);
        contact.normal = entry.normal;
        contact.tangent = entry.tangent;
        contact.gap = entry.gap;
        contact.dilation = entry.dilation;
        return contact;
    }

    /// The order of contacts whose lower block is the same, see comes_before.
    std::array<int, 3> sort_key(const SelectedContact& selected) const {
        const auto [corner, edge] = selected.entry->pair;
        return {std::max(topology_.block_of[index(corner)], topology_.block_of[index(edge)]), corner, edge};
    }

  private:
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    const Vec2& at(int corner) const { return input_.vertices[index(corner)]; }
    /// Where a corner is expected at the step's end.
    Vec2 expected(int corner) const { return 2 * input_.mid_step_vertices[index(corner)] - at(corner); }
    int next(int corner) const { return topology_.next[index(corner)]; }
    int previous(int corner) const { return topology_.previous[index(corner)]; }

    int lower_block(const ContactCandidate& entry) const {
        return std::min(topology_.block_of[index(entry.pair.corner)],
                        topology_.block_of[index(entry.pair.edge)]);
    }
    static std::vector<int> corners_of(std::span<const Contact> contacts) {
        std::vector<int> corners;
        corners.reserve(contacts.size());
        for (const Contact& contact : contacts) corners.push_back(contact.corner);
        return corners;
    }
    const Contact* find_previous(const CornerEdge& candidate) const {
        for (const int k : previous_contacts_.of(candidate.corner)) {
            if (input_.previous[index(k)].edge == candidate.edge) return &input_.previous[index(k)];
        }
        return nullptr;
    }
    bool is_forced(const CornerEdge& candidate) const {
        return std::binary_search(input_.forced.begin(), input_.forced.end(), candidate);
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

    /// Whether `a` is to stand for its line rather than `b`: of two faces along each other only the corner
    /// that ends within the other face can touch it. One that is behind did not come in there; one that holds
    /// stays while it can; a tie, as where two corners coincide, goes to the earlier.
    bool is_preferred(const ContactCandidate& a, const ContactCandidate& b) const {
        if (a.is_behind != b.is_behind) return b.is_behind;
        if (a.remains_on_edge != b.remains_on_edge) return a.remains_on_edge;
        return a.end_margin > b.end_margin + 1e-9 * input_.search_radius;
    }

    /// Whether the corner is expected to be well within its edge's ends, and did not come there from behind.
    bool overlaps(const ContactCandidate& entry) const {
        const double length = (at(next(entry.pair.edge)) - at(entry.pair.edge)).norm();
        return !entry.is_behind &&
               entry.end_margin > (entry.remains_on_edge ? end_tolerance : min_overlap_ratio) * length;
    }

    /// Where two faces overlap by less than the search_radius both ends of the overlap are at one pair of
    /// corners: the entry on the same line that overlaps and is of the other corner; null if there is none.
    const ContactCandidate* opposite_end(std::span<const ContactCandidate* const> members,
                                         const ContactCandidate& best) const {
        const ContactCandidate* other = nullptr;
        for (const ContactCandidate* member : members) {
            const ContactCandidate& entry = *member;
            if (entry.pair.corner == best.pair.corner || !overlaps(entry) ||
                entry.normal.dot(best.normal) > 0 ||
                std::abs(cross(best.normal, entry.normal)) >= parallel_tolerance)
                continue;
            if (other == nullptr || is_preferred(entry, *other)) other = &entry;
        }
        return other;
    }

    /// The half overlaps of the corner's faces with its edge, m.
    double overlap_length(const CornerEdge& pair) const {
        return half_overlap(pair.corner, pair.edge) + half_overlap(previous(pair.corner), pair.edge);
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
    double shared_length(int corner, int partner_corner, const Vec2& tangent) const {
        double sum = 0;
        for (const int a : {corner, previous(corner)}) {
            const Vec2 face = at(next(a)) - at(a);
            if (std::abs(cross(face, tangent)) > parallel_tolerance * face.norm()) continue;
            for (const int b : {partner_corner, previous(partner_corner)}) sum += half_overlap(a, b);
        }
        return sum;
    }

    const Model& model_;
    const Topology& topology_;
    const DetectionInput& input_;
    InheritedPenetrations inherited_penetrations_;
    OwnerIndex previous_contacts_;
};

/// The indices for which `is_selected` says so, ascending.
template <class IsChosen>
std::vector<std::size_t> select(std::size_t count, const ThreadPool& pool, const IsChosen& is_selected) {
    std::vector<char> selected(count, 0);
    pool.parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) selected[k] = is_selected(k) ? 1 : 0;
    });
    std::vector<std::size_t> indices;
    indices.reserve(static_cast<std::size_t>(std::count(selected.begin(), selected.end(), 1)));
    for (std::size_t k = 0; k < count; ++k) {
        if (selected[k] != 0) indices.push_back(k);
    }
    return indices;
}

/// The contacts selected, see comes_before: blocks by counting, those of a block by sorting.
std::vector<Contact> sorted_contacts(const Model& model, const ContactDetector& detector,
                                     std::span<const SelectedContact> selected, const ThreadPool& pool) {
    std::vector<int> blocks(selected.size());
    std::transform(selected.begin(), selected.end(), blocks.begin(),
                   [](const SelectedContact& c) { return c.block; });
    const OwnerIndex by_block(model.block_count(), blocks);
    std::vector<Contact> contacts(selected.size());
    pool.parallel_for(static_cast<std::size_t>(model.block_count()), [&](std::size_t begin, std::size_t end) {
        std::vector<const SelectedContact*> of_block;
        for (std::size_t block = begin; block < end; ++block) {
            of_block.clear();
            const int b = static_cast<int>(block);
            for (const int k : by_block.of(b)) of_block.push_back(&selected[static_cast<std::size_t>(k)]);
            std::sort(of_block.begin(), of_block.end(),
                      [&](const SelectedContact* one, const SelectedContact* other) {
                          return detector.sort_key(*one) < detector.sort_key(*other);
                      });
            Contact* to = contacts.data() + by_block.offset(b);
            for (const SelectedContact* one : of_block) *to++ = detector.make_contact(*one);
        }
    });
    return contacts;
}

}  // namespace

bool passes_entrance_angle_test(const Topology& topology, std::span<const Vec2> vertices, int corner,
                                const Vec2& normal) {
    const auto k = static_cast<std::size_t>(corner);
    const auto at = [&](int c) { return vertices[static_cast<std::size_t>(c)]; };
    const Vec2 leaving = (at(topology.next[k]) - at(corner)).normalized();
    const Vec2 arriving = (at(topology.previous[k]) - at(corner)).normalized();
    if (leaving.dot(normal) < -parallel_tolerance || arriving.dot(normal) < -parallel_tolerance) return false;
    return perpendicular(leaving - arriving).dot(normal) > 0;
}

std::vector<Contact> detect_contacts(const Model& model, const DetectionInput& at,
                                     std::span<const CornerEdge> candidates, const ThreadPool& pool) {
    const ContactDetector detector(model, at);
    // Most candidates are not near: what they are examined for is kept for the others only.
    const std::vector<std::size_t> near =
        select(candidates.size(), pool, [&](std::size_t k) { return detector.is_near(candidates[k]); });
    std::vector<ContactCandidate> evaluated(near.size());
    const std::vector<std::size_t> accepted = select(near.size(), pool, [&](std::size_t k) {
        return detector.evaluate_candidate(candidates[near[k]], evaluated[k]);
    });

    std::vector<SelectedContact> selected;
    selected.reserve(accepted.size());
    std::vector<std::pair<std::pair<int, int>, std::size_t>> grouped;  // (corner pair, entry)
    grouped.reserve(accepted.size());
    for (const std::size_t k : accepted) {
        if (evaluated[k].partner_corner < 0) {
            selected.push_back(detector.select_single(evaluated[k]));
        } else {
            grouped.push_back({std::minmax(evaluated[k].pair.corner, evaluated[k].partner_corner), k});
        }
    }
    std::sort(grouped.begin(), grouped.end());
    std::vector<const ContactCandidate*> members;
    std::vector<EntranceLine> lines;
    int group = 0;
    for (std::size_t k = 0; k < grouped.size(); ++group) {
        members.clear();
        const auto corners = grouped[k].first;
        for (; k < grouped.size() && grouped[k].first == corners; ++k)
            members.push_back(&evaluated[grouped[k].second]);
        detector.select_entrance_lines(members, group, lines, selected);
    }
    return sorted_contacts(model, detector, selected, pool);
}

}  // namespace rockslope::dda
