#include "dda/contact/detect.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dda/contact/by_owner.hpp"
#include "dda/contact/candidates.hpp"
#include "dda/contact/known_depth.hpp"

namespace dda {

namespace {

/// A contact in the making: what is found out of a candidate before it is known which of them become
/// contacts.
struct Entry {
    CornerEdge pair;
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    double gap = 0;          ///< m, less the dilation
    double dilation = 0;     ///< m
    double known_depth = 0;  ///< m
    bool held_back = false;
    double inside = 0;    ///< m, projection inside the ends where the corner is expected to go
    int partner = -1;     ///< the edge's end that the corner is near, or -1
    bool holds = false;   ///< it carried force at the end of the last step, and its corner is on its edge
    bool stays = false;   ///< and is expected to stay on it
    bool behind = false;  ///< open, and its corner is behind it: it did not come in here
};

/// An entry that becomes a contact.
struct Chosen {
    const Entry* entry = nullptr;
    ContactKind kind = ContactKind::vertex_edge;
    double length = 0;
    int group = -1;
    int line = 0;
    bool held_back = false;
    int block = 0;  ///< the lower of the two that it is between
};

/// Entries of one pair of corners whose normals are parallel.
struct Line {
    const Entry* best = nullptr;
    bool holds = false;
};

/// How far two faces must overlap, as a share of the edge, for a second contact to come into being where the
/// other end of the overlap has one: below that, slip to and fro would make and unmake it.
constexpr double least_overlap = 1e-3;

class Detector {
  public:
    Detector(const Model& model, const Detection& detection)
        : model_(model),
          topology_(model.topology),
          d_(detection),
          known_(model.topology, d_.vertices, d_.previous, d_.reach),
          previous_(model.topology.corner_count(), corners_of(d_.previous)) {}

    /// Whether a candidate is worth examining: it is within reach, or was a contact before.
    bool is_near(const CornerEdge& candidate) const {
        const auto [corner, edge] = candidate;
        return distance_to_segment(at(corner), at(edge), at(next(edge))) <= d_.reach ||
               find_previous(candidate) != nullptr || enters(candidate);
    }

    /// Fills the entry for a candidate. @return whether it is a contact at all.
    bool examine(const CornerEdge& candidate, Entry& entry) const {
        const auto [corner, edge] = candidate;
        const Vec2& vertex = at(corner);
        const CornerEdgeGeometry geometry = corner_edge_geometry(vertex, at(edge), at(next(edge)));
        entry.pair = candidate;
        const Contact* old = find_previous(candidate);
        const bool enters = this->enters(candidate);
        if (!enters) {
            // An open contact farther off keeps what it knows, but nothing to close on: it may be off its
            // edge's end, on the line that goes on from there.
            entry.held_back = (old == nullptr || old->state == ContactState::open) &&
                              distance_to_segment(vertex, at(edge), at(next(edge))) > d_.reach;
            if (old == nullptr && entry.held_back) return false;
            // What bears force keeps the corner out until it opens or slides off the edge.
            const bool bears = old != nullptr && old->state != ContactState::open &&
                               geometry.inside() >= -end_slack * geometry.length;
            if (!bears && !faces_outwards(topology_, d_.vertices, corner, geometry.normal)) return false;
        }

        entry.normal = geometry.normal;
        entry.tangent = geometry.tangent;
        entry.dilation = old != nullptr ? old->dilation : 0;
        entry.gap = geometry.gap - entry.dilation;
        const int end = geometry.along < geometry.length / 2 ? edge : next(edge);
        const bool closed = old != nullptr && old->state != ContactState::open;
        entry.known_depth =
            std::max(known_.along(corner, geometry.normal), known_.along(end, -geometry.normal));
        entry.inside = corner_edge_geometry(expected(corner), expected(edge), expected(next(edge))).inside();
        entry.holds = closed && geometry.inside() >= -end_slack * geometry.length;
        entry.stays = entry.holds && entry.inside >= -end_slack * geometry.length;
        entry.behind = !closed && !enters &&
                       entry.gap + std::max(entry.dilation, 0.0) < -(d_.rounding + 2 * entry.known_depth);
        entry.partner = !enters && (vertex - at(end)).norm() <= d_.reach && !is_reflex(end) ? end : -1;
        return true;
    }

    /// Chooses among the entries of one pair of corners, with a common group where they have more than one
    /// line: one for each line, or one for each corner where both are in the other's face.
    /// @param lines work space.
    void choose_of_group(std::span<const Entry* const> members, int group, std::vector<Line>& lines,
                         std::vector<Chosen>& out) const {
        lines.clear();
        for (const Entry* entry : members) {
            const auto same = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
                return std::abs(cross(line.best->normal, entry->normal)) < parallel_tolerance;
            });
            Line& line = same == lines.end() ? lines.emplace_back() : *same;
            if (line.best == nullptr || better(*entry, *line.best)) line.best = entry;
            line.holds = line.holds || entry->holds;
        }
        const auto holder =
            std::find_if(lines.begin(), lines.end(), [](const Line& line) { return line.holds; });
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const Line& line = lines[k];
            // A line that holds keeps the group, however deep: the others cannot close.
            const bool held_back = holder != lines.end() && &*holder != &line;
            const auto choose = [&](const Entry* entry, double length) {
                const ContactKind kind = length > 0 ? ContactKind::edge_edge : ContactKind::vertex_vertex;
                out.push_back({entry, kind, length, lines.size() > 1 ? group : -1, static_cast<int>(k),
                               held_back, lower_block(*entry)});
            };
            const Entry* other = overlaps(*line.best) ? other_corner(members, *line.best) : nullptr;
            if (other == nullptr) {
                choose(line.best,
                       shared_length(line.best->pair.corner, line.best->partner, line.best->tangent));
            } else {
                choose(line.best, overlap_length(line.best->pair));
                choose(other, overlap_length(other->pair));
            }
        }
    }

    Chosen choose_single(const Entry& entry) const {
        const double length = overlap_length(entry.pair);
        const ContactKind kind = length > 0 ? ContactKind::edge_edge : ContactKind::vertex_edge;
        return {&entry, kind, length, -1, 0, entry.held_back, lower_block(entry)};
    }

    Contact contact_of(const Chosen& chosen) const {
        const Entry& entry = *chosen.entry;
        Contact contact;
        contact.corner = entry.pair.corner;
        contact.edge = entry.pair.edge;
        contact.corner_block = topology_.block_of[index(contact.corner)];
        contact.edge_block = topology_.block_of[index(contact.edge)];
        contact.kind = chosen.kind;
        contact.joint_material = joint_material_of(contact.corner, contact.edge);
        contact.joint = topology_.joint[index(contact.edge)];
        contact.group = chosen.group;
        contact.line = chosen.line;
        contact.held_back = chosen.held_back;
        contact.known_depth = entry.known_depth;
        contact.length = chosen.length;
        contact.point = at(contact.corner);
        contact.normal = entry.normal;
        contact.tangent = entry.tangent;
        contact.gap = entry.gap;
        contact.dilation = entry.dilation;
        return contact;
    }

    /// The order of contacts whose lower block is the same, see comes_before.
    std::array<int, 3> place_of(const Chosen& chosen) const {
        const auto [corner, edge] = chosen.entry->pair;
        return {std::max(topology_.block_of[index(corner)], topology_.block_of[index(edge)]), corner, edge};
    }

  private:
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    const Vec2& at(int corner) const { return d_.vertices[index(corner)]; }
    /// Where a corner is expected at the step's end.
    Vec2 expected(int corner) const { return 2 * d_.half_way[index(corner)] - at(corner); }
    int next(int corner) const { return topology_.next[index(corner)]; }
    int previous(int corner) const { return topology_.previous[index(corner)]; }

    int lower_block(const Entry& entry) const {
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
        for (const int k : previous_.of(candidate.corner)) {
            if (d_.previous[index(k)].edge == candidate.edge) return &d_.previous[index(k)];
        }
        return nullptr;
    }
    bool enters(const CornerEdge& candidate) const {
        return std::binary_search(d_.entering.begin(), d_.entering.end(), candidate);
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
    bool better(const Entry& a, const Entry& b) const {
        if (a.behind != b.behind) return b.behind;
        if (a.stays != b.stays) return a.stays;
        return a.inside > b.inside + 1e-9 * d_.reach;
    }

    /// Whether the corner is expected to be well within its edge's ends, and did not come there from behind.
    bool overlaps(const Entry& entry) const {
        const double length = (at(next(entry.pair.edge)) - at(entry.pair.edge)).norm();
        return !entry.behind && entry.inside > (entry.stays ? end_slack : least_overlap) * length;
    }

    /// Where two faces overlap by less than the reach both ends of the overlap are at one pair of corners:
    /// the entry on the same line that overlaps and is of the other corner; null if there is none.
    const Entry* other_corner(std::span<const Entry* const> members, const Entry& best) const {
        const Entry* other = nullptr;
        for (const Entry* member : members) {
            const Entry& entry = *member;
            if (entry.pair.corner == best.pair.corner || !overlaps(entry) ||
                entry.normal.dot(best.normal) > 0 ||
                std::abs(cross(best.normal, entry.normal)) >= parallel_tolerance)
                continue;
            if (other == nullptr || better(entry, *other)) other = &entry;
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
    const Detection& d_;
    KnownDepths known_;
    ByOwner previous_;
};

/// The indices for which `is_chosen` says so, ascending.
template <class IsChosen>
std::vector<std::size_t> choose(std::size_t count, const Crew& crew, const IsChosen& is_chosen) {
    std::vector<char> chosen(count, 0);
    crew.for_ranges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) chosen[k] = is_chosen(k) ? 1 : 0;
    });
    std::vector<std::size_t> indices;
    indices.reserve(static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), 1)));
    for (std::size_t k = 0; k < count; ++k) {
        if (chosen[k] != 0) indices.push_back(k);
    }
    return indices;
}

/// The contacts chosen, see comes_before: blocks by counting, those of a block by sorting.
std::vector<Contact> in_order(const Model& model, const Detector& detector, std::span<const Chosen> chosen,
                              const Crew& crew) {
    std::vector<int> blocks(chosen.size());
    std::transform(chosen.begin(), chosen.end(), blocks.begin(), [](const Chosen& c) { return c.block; });
    const ByOwner by_block(model.block_count(), blocks);
    std::vector<Contact> contacts(chosen.size());
    crew.for_ranges(static_cast<std::size_t>(model.block_count()), [&](std::size_t begin, std::size_t end) {
        std::vector<const Chosen*> of_block;
        for (std::size_t block = begin; block < end; ++block) {
            of_block.clear();
            const int b = static_cast<int>(block);
            for (const int k : by_block.of(b)) of_block.push_back(&chosen[static_cast<std::size_t>(k)]);
            std::sort(of_block.begin(), of_block.end(), [&](const Chosen* one, const Chosen* other) {
                return detector.place_of(*one) < detector.place_of(*other);
            });
            Contact* to = contacts.data() + by_block.before(b);
            for (const Chosen* one : of_block) *to++ = detector.contact_of(*one);
        }
    });
    return contacts;
}

}  // namespace

bool faces_outwards(const Topology& topology, std::span<const Vec2> vertices, int corner,
                    const Vec2& normal) {
    const auto k = static_cast<std::size_t>(corner);
    const auto at = [&](int c) { return vertices[static_cast<std::size_t>(c)]; };
    const Vec2 leaving = (at(topology.next[k]) - at(corner)).normalized();
    const Vec2 arriving = (at(topology.previous[k]) - at(corner)).normalized();
    if (leaving.dot(normal) < -parallel_tolerance || arriving.dot(normal) < -parallel_tolerance) return false;
    return perpendicular(leaving - arriving).dot(normal) > 0;
}

std::vector<Contact> detect_contacts(const Model& model, const Detection& at,
                                     std::span<const CornerEdge> candidates, const Crew& crew) {
    const Detector detector(model, at);
    // Most candidates are not near: what they are examined for is kept for the others only.
    const std::vector<std::size_t> near =
        choose(candidates.size(), crew, [&](std::size_t k) { return detector.is_near(candidates[k]); });
    std::vector<Entry> examined(near.size());
    const std::vector<std::size_t> accepted = choose(
        near.size(), crew, [&](std::size_t k) { return detector.examine(candidates[near[k]], examined[k]); });

    std::vector<Chosen> chosen;
    chosen.reserve(accepted.size());
    std::vector<std::pair<std::pair<int, int>, std::size_t>> grouped;  // (corner pair, entry)
    grouped.reserve(accepted.size());
    for (const std::size_t k : accepted) {
        if (examined[k].partner < 0) {
            chosen.push_back(detector.choose_single(examined[k]));
        } else {
            grouped.push_back({std::minmax(examined[k].pair.corner, examined[k].partner), k});
        }
    }
    std::sort(grouped.begin(), grouped.end());
    std::vector<const Entry*> members;
    std::vector<Line> lines;
    int group = 0;
    for (std::size_t k = 0; k < grouped.size(); ++group) {
        members.clear();
        const auto corners = grouped[k].first;
        for (; k < grouped.size() && grouped[k].first == corners; ++k)
            members.push_back(&examined[grouped[k].second]);
        detector.choose_of_group(members, group, lines, chosen);
    }
    return in_order(model, detector, chosen, crew);
}

}  // namespace dda
