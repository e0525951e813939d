#include "dda/contact/detect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "common/base/parallel_parts.hpp"
#include "dda/contact/candidates.hpp"
#include "dda/contact/corner_meetings.hpp"
#include "dda/contact/edge_directions.hpp"
#include "dda/contact/inherited_penetration.hpp"
#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

namespace {

/// A candidate that may become a contact, with the geometry from which entrance lines are selected.
struct ContactCandidate {
    CornerEdge pair;
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    double gap = 0;                    ///< m, distance less the dilation
    double dilation = 0;               ///< m
    double inherited_penetration = 0;  ///< m, see Contact
    bool inhibited = false;            ///< see Contact
    double end_margin = 0;             ///< m, CornerEdgeGeometry::end_margin predicted for the step's end
    CornerIndex partner_corner = CornerIndex::none();  ///< convex end of the edge within the search radius
    bool carries_force = false;    ///< it bore force at the last step's end, and its corner is on the edge
    bool remains_on_edge = false;  ///< it carries force, and its corner is predicted to stay on the edge
    bool is_behind = false;        ///< open, with its corner behind the line: it entered through another edge
};

/// A candidate selected to become a contact.
struct SelectedContact {
    const ContactCandidate* candidate = nullptr;
    ContactKind kind = ContactKind::vertex_edge;
    double length = 0;  ///< m
    int group = -1;
    int line = 0;
    bool inhibited = false;
    BlockIndex block;  ///< the lower of its two blocks
};

/// An entrance line of a pair of corners: the candidates of the pair whose normals are parallel.
struct EntranceLine {
    const ContactCandidate* best = nullptr;
    bool carries_force = false;  ///< one of its candidates does
};

/// Contact detection of a step: evaluates candidates, selects entrance lines and makes contacts.
class ContactDetector {
  public:
    ContactDetector(const Model& model, const DetectionInput& detection, const ThreadPool& pool)
        : model_(model),
          topology_(model.topology),
          input_(detection),
          inherited_penetrations_(model.topology, input_.vertices, input_.previous,
                                  input_.search_radius.largest(), pool),
          previous_contacts_(model.topology.corner_count(), corners_of(input_.previous, pool)),
          previous_edges_(edges_of(input_.previous, pool)),
          directions_(edge_directions(model.topology, input_.vertices, pool)) {}

    /// Whether a pair must be evaluated: it is within its search radius, was a contact before, or is forced.
    bool is_near(const CornerEdge& pair) const {
        const auto [corner, edge] = pair;
        return (is_within(input_.search_radius.largest(), at(corner), start(edge), end(edge)) &&
                may_meet(pair)) ||
               find_previous(pair) != nullptr || is_forced(pair);
    }

    /// Fills in the candidate of a pair. @return whether the pair may become a contact.
    bool evaluate_candidate(const CornerEdge& pair, ContactCandidate& candidate) const {
        const auto [corner, edge] = pair;
        const Vec2& vertex = at(corner);
        const CornerEdgeGeometry geometry =
            corner_edge_geometry(vertex, start(edge), directions_[edge].tangent, directions_[edge].length);
        candidate.pair = pair;
        const Contact* old = find_previous(pair);
        const bool is_forced = this->is_forced(pair);
        if (!is_forced) {
            // An open contact beyond the search radius keeps its history but cannot close: its corner may be
            // past the end of the edge, on the edge's extension.
            candidate.inhibited = (old == nullptr || old->state == ContactState::open) && !may_meet(pair);
            if (old == nullptr && candidate.inhibited) return false;
            // A contact that bears force is kept, whatever the angle, until it opens or slides off the edge.
            const bool bears_force = old != nullptr && old->state != ContactState::open &&
                                     geometry.end_margin() >= -end_tolerance * geometry.length;
            if (!bears_force &&
                !passes_entrance_angle_test(directions_[edge_from(corner)].tangent,
                                            -directions_[edge_to(corner)].tangent, geometry.normal))
                return false;
        }

        candidate.normal = geometry.normal;
        candidate.tangent = geometry.tangent;
        candidate.dilation = old != nullptr ? old->dilation : 0;
        candidate.gap = geometry.gap - candidate.dilation;
        const CornerIndex near_end =
            geometry.along < geometry.length / 2 ? start_of(edge) : topology_.end_of(edge);
        const bool closed = old != nullptr && old->state != ContactState::open;
        candidate.inherited_penetration = std::max(inherited_penetrations_.along(corner, geometry.normal),
                                                   inherited_penetrations_.along(near_end, -geometry.normal));
        candidate.end_margin = corner_edge_geometry(predicted(corner), predicted(start_of(edge)),
                                                    predicted(topology_.end_of(edge)))
                                   .end_margin();
        candidate.carries_force = closed && geometry.end_margin() >= -end_tolerance * geometry.length;
        candidate.remains_on_edge =
            candidate.carries_force && candidate.end_margin >= -end_tolerance * geometry.length;
        candidate.is_behind = !closed && !is_forced &&
                              candidate.gap + std::max(candidate.dilation, 0.0) <
                                  -(input_.depth_tolerance + 2 * candidate.inherited_penetration);
        candidate.partner_corner = !is_forced &&
                                           (vertex - at(near_end)).norm() <= input_.search_radius.largest() &&
                                           !is_reflex(near_end)
                                       ? near_end
                                       : CornerIndex::none();
        return true;
    }

    /// Sorts the candidates of one pair of corners into entrance lines and selects one contact per line. It
    /// selects two, one for each corner, where two faces overlap by less than the search radius. Contacts on
    /// more than one line form a group.
    /// @param lines work space.
    void select_entrance_lines(std::span<const ContactCandidate* const> members, int group,
                               std::vector<EntranceLine>& lines, std::vector<SelectedContact>& out) const {
        lines.clear();
        for (const ContactCandidate* candidate : members) {
            const auto same = std::find_if(lines.begin(), lines.end(), [&](const EntranceLine& line) {
                return std::abs(cross(line.best->normal, candidate->normal)) < parallel_tolerance;
            });
            EntranceLine& line = same == lines.end() ? lines.emplace_back() : *same;
            if (line.best == nullptr || is_preferred(*candidate, *line.best)) line.best = candidate;
            line.carries_force = line.carries_force || candidate->carries_force;
        }
        const auto loaded_line = std::find_if(lines.begin(), lines.end(),
                                              [](const EntranceLine& line) { return line.carries_force; });
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const EntranceLine& line = lines[k];
            // The line that bears force keeps the group, whatever its depth: the others cannot close.
            const bool inhibited = loaded_line != lines.end() && &*loaded_line != &line;
            const auto select = [&](const ContactCandidate* candidate, double length) {
                const ContactKind kind = length > 0 ? ContactKind::edge_edge : ContactKind::vertex_vertex;
                out.push_back({candidate, kind, length, lines.size() > 1 ? group : -1, static_cast<int>(k),
                               inhibited, lower_block(*candidate)});
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

    /// The contact of a candidate whose corner is far from both ends of the edge.
    SelectedContact select_single(const ContactCandidate& candidate) const {
        const double length = overlap_length(candidate.pair);
        const ContactKind kind = length > 0 ? ContactKind::edge_edge : ContactKind::vertex_edge;
        return {&candidate, kind, length, -1, 0, candidate.inhibited, lower_block(candidate)};
    }

    /// The contact of a selected candidate: geometry, joint and length. Its state is that of a new contact.
    Contact make_contact(const SelectedContact& selected) const {
        const ContactCandidate& candidate = *selected.candidate;
        Contact contact;
        contact.corner = candidate.pair.corner;
        contact.edge = candidate.pair.edge;
        contact.corner_block = topology_.block_of[contact.corner];
        contact.edge_block = topology_.block_of_edge(contact.edge);
        contact.kind = selected.kind;
        contact.joint_material = joint_material_of(contact.corner, contact.edge);
        contact.joint = topology_.joint[contact.edge];
        contact.group = selected.group;
        contact.line = selected.line;
        contact.inhibited = selected.inhibited;
        contact.inherited_penetration = candidate.inherited_penetration;
        contact.length = selected.length;
        contact.point = at(contact.corner);
        contact.normal = candidate.normal;
        contact.tangent = candidate.tangent;
        contact.gap = candidate.gap;
        contact.dilation = candidate.dilation;
        return contact;
    }

    /// Sort key in the order of comes_before, for contacts with the same lower block.
    std::tuple<BlockIndex, CornerIndex, EdgeIndex> sort_key(const SelectedContact& selected) const {
        const auto [corner, edge] = selected.candidate->pair;
        return {std::max(topology_.block_of[corner], topology_.block_of_edge(edge)), corner, edge};
    }

  private:
    const Vec2& at(CornerIndex corner) const { return input_.vertices[corner]; }
    const Vec2& start(EdgeIndex edge) const { return at(start_of(edge)); }
    const Vec2& end(EdgeIndex edge) const { return at(topology_.end_of(edge)); }
    /// Predicted position of a corner at the step's end, m.
    Vec2 predicted(CornerIndex corner) const { return 2 * input_.mid_step_vertices[corner] - at(corner); }
    /// Predicted displacement of a corner in the step, m.
    Vec2 motion(CornerIndex corner) const { return 2 * (input_.mid_step_vertices[corner] - at(corner)); }
    /// Whether a corner is within its search radius of an edge.
    bool may_meet(const CornerEdge& pair) const {
        const auto [corner, edge] = pair;
        const Vec2 of_corner = motion(corner);
        const double relative =
            std::sqrt(std::max((of_corner - motion(start_of(edge))).squaredNorm(),
                               (of_corner - motion(topology_.end_of(edge))).squaredNorm()));
        return is_within(input_.search_radius.of(relative), at(corner), start(edge), end(edge));
    }
    /// The edges that end and begin at a corner.
    EdgeIndex edge_to(CornerIndex corner) const { return edge_from(topology_.previous[corner]); }
    std::array<EdgeIndex, 2> edges_at(CornerIndex corner) const {
        return {edge_from(corner), edge_to(corner)};
    }

    BlockIndex lower_block(const ContactCandidate& candidate) const {
        return std::min(topology_.block_of[candidate.pair.corner],
                        topology_.block_of_edge(candidate.pair.edge));
    }
    static PerContact<EdgeIndex> edges_of(ContactSpan<const Contact> contacts, const ThreadPool& pool) {
        PerContact<EdgeIndex> edges(contacts.size());
        pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) edges[k] = contacts[k].edge;
        });
        return edges;
    }
    static std::vector<CornerIndex> corners_of(ContactSpan<const Contact> contacts, const ThreadPool& pool) {
        std::vector<CornerIndex> corners(contacts.size());
        pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) corners[k] = contacts[k].corner;
        });
        return corners;
    }
    /// The contact of a pair at the start of the step; null if there was none.
    const Contact* find_previous(const CornerEdge& pair) const {
        for (const ContactIndex k : previous_contacts_.of(pair.corner)) {
            if (previous_edges_[k] == pair.edge) return &input_.previous[k];
        }
        return nullptr;
    }
    bool is_forced(const CornerEdge& pair) const {
        return std::binary_search(input_.forced.begin(), input_.forced.end(), pair);
    }

    bool is_reflex(CornerIndex corner) const {
        const Vec2 arriving = at(corner) - at(topology_.previous[corner]);
        const Vec2 leaving = at(topology_.next[corner]) - at(corner);
        return cross(arriving, leaving) < -parallel_tolerance * arriving.norm() * leaving.norm();
    }

    /// The joint material of the edge; if the edge is free, that of the edge of the corner that lies more
    /// along it, or else of the other one; else the default.
    JointMaterialIndex joint_material_of(CornerIndex corner, EdgeIndex edge) const {
        const Vec2& along = directions_[edge].tangent;
        EdgeIndex on_it = edge_from(corner), other = edge_to(corner);
        if (directions_[other].tangent.dot(along) < directions_[on_it].tangent.dot(along))
            std::swap(on_it, other);
        for (const EdgeIndex e : {edge, on_it, other}) {
            const JointMaterialIndex material = topology_.joint_material[e];
            if (material.exists()) return material;
        }
        return model_.default_joint_material;
    }

    /// Whether `a` rather than `b` becomes the contact of their entrance line. Candidates behind the line
    /// come last, since their corner did not enter there. A candidate that carries force and stays on its
    /// edge comes first. Then the larger end margin wins: where two faces lie along each other, only the
    /// corner that ends within the other face can touch it. In a tie, as of two coincident corners, `b` wins:
    /// it came first.
    bool is_preferred(const ContactCandidate& a, const ContactCandidate& b) const {
        if (a.is_behind != b.is_behind) return b.is_behind;
        if (a.remains_on_edge != b.remains_on_edge) return a.remains_on_edge;
        return a.end_margin > b.end_margin + 1e-9 * input_.search_radius.largest();
    }

    /// Whether the corner is predicted to end the step between the ends of its edge, and did not enter
    /// through another edge.
    bool overlaps(const ContactCandidate& candidate) const {
        const double length = (end(candidate.pair.edge) - start(candidate.pair.edge)).norm();
        const double min_ratio = candidate.remains_on_edge ? end_tolerance : min_overlap_ratio;
        return !candidate.is_behind && candidate.end_margin > min_ratio * length;
    }

    /// The candidate at the other end of the overlap on which `best` lies; null if there is none. Where two
    /// faces overlap by less than the search radius, both ends of the overlap are at one pair of corners.
    const ContactCandidate* opposite_end(std::span<const ContactCandidate* const> members,
                                         const ContactCandidate& best) const {
        const ContactCandidate* other = nullptr;
        for (const ContactCandidate* member : members) {
            const ContactCandidate& candidate = *member;
            if (candidate.pair.corner == best.pair.corner || !overlaps(candidate) ||
                candidate.normal.dot(best.normal) > 0 ||
                std::abs(cross(best.normal, candidate.normal)) >= parallel_tolerance)
                continue;
            if (other == nullptr || is_preferred(candidate, *other)) other = &candidate;
        }
        return other;
    }

    /// Contact length of a pair, m: the sum of the half overlaps of the edge with both edges of the corner.
    double overlap_length(const CornerEdge& pair) const {
        return half_overlap(edge_from(pair.corner), pair.edge) +
               half_overlap(edge_to(pair.corner), pair.edge);
    }

    /// Half the length over which edges `a` and `b` lie on each other, m; zero unless they are antiparallel.
    double half_overlap(EdgeIndex a, EdgeIndex b) const {
        const Vec2 along = end(b) - start(b);
        const double length = along.norm();
        const Vec2 face = end(a) - start(a);
        if (along.dot(face) >= 0 || std::abs(cross(along, face)) > parallel_tolerance * length * face.norm())
            return 0;
        const double from = std::max(0.0, (end(a) - start(b)).dot(along) / length);
        const double to = std::min(length, (start(a) - start(b)).dot(along) / length);
        return std::max(0.0, to - from) / 2;
    }

    /// Contact length of a pair of corners, m: the sum of the half overlaps of all their edges along
    /// `tangent`.
    double shared_length(CornerIndex corner, CornerIndex partner_corner, const Vec2& tangent) const {
        double sum = 0;
        for (const EdgeIndex a : edges_at(corner)) {
            const Vec2 face = end(a) - start(a);
            if (std::abs(cross(face, tangent)) > parallel_tolerance * face.norm()) continue;
            for (const EdgeIndex b : edges_at(partner_corner)) sum += half_overlap(a, b);
        }
        return sum;
    }

    const Model& model_;
    const Topology& topology_;
    const DetectionInput& input_;
    InheritedPenetrations inherited_penetrations_;
    OwnerIndex<CornerIndex, ContactIndex> previous_contacts_;
    PerContact<EdgeIndex> previous_edges_;
    PerEdge<EdgeDirection> directions_;  ///< at the start of the step
};

/// Candidates that may become contacts, and what is selected of them so far.
struct EvaluatedPairs {
    std::vector<ContactCandidate> candidates;
    std::vector<SelectedContact> singles;       ///< whose corner is far from both ends of the edge
    CornerMeetings<ContactCandidate> meetings;  ///< of the others
};

EvaluatedPairs evaluate_pairs(const ContactDetector& detector, std::span<const CornerEdge> pairs) {
    // Most pairs are not near; only near ones get memory for their evaluation.
    std::vector<CornerEdge> near;
    near.reserve(pairs.size());
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(near),
                 [&](const CornerEdge& pair) { return detector.is_near(pair); });
    EvaluatedPairs evaluated;
    evaluated.candidates.reserve(near.size());  // they must keep their places
    evaluated.singles.reserve(near.size());
    evaluated.meetings.reserve(near.size());
    for (const CornerEdge& pair : near) {
        ContactCandidate& candidate = evaluated.candidates.emplace_back();
        if (!detector.evaluate_candidate(pair, candidate))
            evaluated.candidates.pop_back();
        else if (candidate.partner_corner.exists())
            evaluated.meetings.add(candidate);
        else
            evaluated.singles.push_back(detector.select_single(candidate));
    }
    return evaluated;
}

/// The contacts of the meetings [begin, end) of corners.
std::vector<SelectedContact> select_of_meetings(const ContactDetector& detector,
                                                const CornerMeetings<ContactCandidate>& meetings,
                                                std::size_t begin, std::size_t end) {
    std::vector<SelectedContact> selected;
    // Each meeting may give two contacts for each candidate.
    selected.reserve(2 * (meetings.first(end) - meetings.first(begin)));
    std::vector<EntranceLine> lines;
    for (std::size_t meeting = begin; meeting < end; ++meeting)
        detector.select_entrance_lines(meetings.of(meeting), static_cast<int>(meeting), lines, selected);
    return selected;
}

/// The selected contacts in the order of comes_before: a counting sort by lower block, then a sort within
/// each.
std::vector<Contact> sorted_contacts(const Model& model, const ContactDetector& detector,
                                     std::span<const SelectedContact> selected, const ThreadPool& pool) {
    std::vector<BlockIndex> blocks(selected.size());
    std::transform(selected.begin(), selected.end(), blocks.begin(),
                   [](const SelectedContact& c) { return c.block; });
    const OwnerIndex<BlockIndex, std::uint32_t> by_block(model.block_count(), blocks);
    std::vector<Contact> contacts(selected.size());
    pool.parallel_for(model.block_count(), [&](std::size_t begin, std::size_t end) {
        std::vector<const SelectedContact*> of_block;
        for (const BlockIndex block : indices<BlockIndex>(begin, end)) {
            of_block.clear();
            for (const std::uint32_t k : by_block.of(block)) of_block.push_back(&selected[k]);
            std::sort(of_block.begin(), of_block.end(),
                      [&](const SelectedContact* one, const SelectedContact* other) {
                          return detector.sort_key(*one) < detector.sort_key(*other);
                      });
            Contact* to = contacts.data() + by_block.offset(block);
            for (const SelectedContact* one : of_block) *to++ = detector.make_contact(*one);
        }
    });
    return contacts;
}

}  // namespace

bool passes_entrance_angle_test(const Topology& topology, CornerSpan<const Vec2> vertices, CornerIndex corner,
                                const Vec2& normal) {
    return passes_entrance_angle_test((vertices[topology.next[corner]] - vertices[corner]).normalized(),
                                      (vertices[topology.previous[corner]] - vertices[corner]).normalized(),
                                      normal);
}

bool passes_entrance_angle_test(const Vec2& leaving, const Vec2& arriving, const Vec2& normal) {
    // The entrance angle, Eq. (27).
    if (leaving.dot(normal) < -parallel_tolerance || arriving.dot(normal) < -parallel_tolerance) return false;
    return perpendicular(leaving - arriving).dot(normal) > 0;
}

std::vector<Contact> detect_contacts(const Model& model, const DetectionInput& at,
                                     std::span<const CornerEdge> candidates, const ThreadPool& pool) {
    const ContactDetector detector(model, at, pool);
    const std::vector<EvaluatedPairs> parts =
        parallel_parts(pool, candidates.size(), [&](std::size_t begin, std::size_t end) {
            return evaluate_pairs(detector, candidates.subspan(begin, end - begin));
        });
    CornerMeetings<ContactCandidate> meetings;
    for (const EvaluatedPairs& part : parts) meetings.add(part.meetings);
    meetings.sort(model.topology.corner_count(), pool);
    const auto of_meetings = parallel_parts(pool, meetings.count(), [&](std::size_t begin, std::size_t end) {
        return select_of_meetings(detector, meetings, begin, end);
    });
    std::vector<SelectedContact> selected;
    for (const EvaluatedPairs& part : parts) append(selected, part.singles);
    for (const std::vector<SelectedContact>& part : of_meetings) append(selected, part);
    return sorted_contacts(model, detector, selected, pool);
}

}  // namespace rockslope::dda
