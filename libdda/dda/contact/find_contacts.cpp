#include "dda/contact/find_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/contact/candidates.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"
#include "dda/contact/transfer.hpp"

namespace dda {

namespace {

/// Candidates are kept while nothing has moved half of what their distance exceeds the reach by. As a share
/// of the median edge: normally 0.1 to 0.5; more finds candidates less often, and finds more of them.
constexpr double skin_share = 0.25;
/// s, in which a spring's gap of rest, where a contact came into being inside a face or took over another's
/// force, falls by e. Springs that took their full depth at once would shake the blocks, and to and fro would
/// pump energy into them; ones that never did would let a block sink deeper with every face that it slides on
/// to. In a static stage nothing shakes, and springs take their depth at once.
constexpr double rest_gap_time = 5;

/// A corner moved by more than this since the candidates were found, m; infinity where there are none.
double moved_since(const ContactSet& last, std::span<const Vec2> vertices) {
    if (last.reference.size() != vertices.size()) return std::numeric_limits<double>::infinity();
    double moved = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k)
        moved = std::max(moved, (vertices[k] - last.reference[k]).norm());
    return moved;
}

/// A set without contacts whose candidates are complete within the reach.
ContactSet with_candidates(const Model& model, const ContactSet& last, const ContactSearch& search) {
    ContactSet set;
    if (search.reach + 2 * moved_since(last, search.vertices) <= last.candidate_distance) {
        set.candidates = last.candidates;
        set.candidate_distance = last.candidate_distance;
        set.reference = last.reference;
    } else {
        set.candidate_distance = std::max(skin_share * search.edge_length, 2 * search.reach);
        set.candidates = find_candidates(model, search.vertices, set.candidate_distance);
        set.reference.assign(search.vertices.begin(), search.vertices.end());
    }
    return set;
}

/// Where the spring of a contact rests at the step's start, and what it bears there.
void load_spring(const Model& model, double kept_rest_gap, Contact& contact) {
    // What is inside without a force is kept from getting deeper, and gains no energy.
    if (contact.state == ContactState::open)
        contact.rest_gap = std::min(contact.gap, 0.0);
    else if (!model.augments(contact.joint_material))
        contact.rest_gap *= kept_rest_gap;
    const double force = normal_spring(model, contact).force(contact.rest_gap - contact.gap);
    contact.normal_force = contact.state != ContactState::open && (force > 0 || contact.bonded) ? force : 0;
}

}  // namespace

FoundContacts find_contacts(const Model& model, const ContactSet& last, const ContactSearch& search,
                            const Crew& crew, PhaseTimes* times) {
    ContactSet set = with_candidates(model, last, search);
    set.contacts = detect_contacts(
        model,
        {search.vertices, search.half_way, search.reach, search.rounding, last.contacts, search.entering},
        set.candidates, crew);
    end_of(Phase::detection, times);
    JointFaces faces = transfer_contacts(model, last.contacts, search.reach, search.first_step, set.contacts);
    const double kept_rest_gap = search.duration > 0 ? std::exp(-search.duration / rest_gap_time) : 0;
    for (Contact& c : set.contacts) {
        load_spring(model, kept_rest_gap, c);
        const bool enters =
            std::binary_search(search.entering.begin(), search.entering.end(), CornerEdge{c.corner, c.edge});
        // A corner enters through a line that it was outside of: one that is open and behind the line belongs
        // elsewhere. Sliding on to a neighbour's face it is as far behind that as it is in the face it
        // leaves.
        if (c.state == ContactState::open && c.from_rock() < -(search.rounding + 2 * c.known_depth) &&
            !enters)
            c.held_back = true;
    }
    end_of(Phase::transfer, times);
    return {std::move(set), std::move(faces)};
}

}  // namespace dda
