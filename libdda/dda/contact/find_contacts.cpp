#include "dda/contact/find_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/contact/candidates.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"
#include "dda/contact/transfer.hpp"

namespace rockslope::dda {

namespace {

/// Candidates are kept while nothing has moved half of what their distance exceeds the search_radius by. As a
/// share of the median edge: normally 0.1 to 0.5; more finds candidates less often, and finds more of them.
constexpr double skin_ratio = 0.25;
/// s, in which a spring's gap of rest, where a contact came into being inside a face or took over another's
/// force, falls by e. Springs that took their full depth at once would shake the blocks, and to and fro would
/// pump energy into them; ones that never did would let a block sink deeper with every face that it slides on
/// to. In a static stage nothing shakes, and springs take their depth at once.
constexpr double stress_free_gap_time = 5;

/// A corner moved by more than this since the candidates were found, m; infinity where there are none.
double displacement_since(const ContactSet& last, std::span<const Vec2> vertices) {
    if (last.reference.size() != vertices.size()) return std::numeric_limits<double>::infinity();
    double moved = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k)
        moved = std::max(moved, (vertices[k] - last.reference[k]).norm());
    return moved;
}

/// A set without contacts whose candidates are complete within the search_radius.
ContactSet find_or_keep_candidates(const Model& model, const ContactSet& last, const ContactSearch& search) {
    ContactSet set;
    if (search.search_radius + 2 * displacement_since(last, search.vertices) <= last.candidate_distance) {
        set.candidates = last.candidates;
        set.candidate_distance = last.candidate_distance;
        set.reference = last.reference;
    } else {
        set.candidate_distance = std::max(skin_ratio * search.edge_length, 2 * search.search_radius);
        set.candidates = find_candidates(model, search.vertices, set.candidate_distance);
        set.reference.assign(search.vertices.begin(), search.vertices.end());
    }
    return set;
}

/// Where the spring of a contact rests at the step's start, and what it bears there.
void initialise_spring(const Model& model, double stress_free_gap_decay, Contact& contact) {
    // What is inside without a force is kept from getting deeper, and gains no energy.
    if (contact.state == ContactState::open)
        contact.stress_free_gap = std::min(contact.gap, 0.0);
    else if (!model.is_augmented(contact.joint_material))
        contact.stress_free_gap *= stress_free_gap_decay;
    const double force = normal_spring(model, contact).force(contact.stress_free_gap - contact.gap);
    contact.normal_force = contact.state != ContactState::open && (force > 0 || contact.bonded) ? force : 0;
}

}  // namespace

FoundContacts find_contacts(const Model& model, const ContactSet& last, const ContactSearch& search,
                            const ThreadPool& pool, PhaseTimes* times) {
    ContactSet set = find_or_keep_candidates(model, last, search);
    set.contacts = detect_contacts(model,
                                   {search.vertices, search.mid_step_vertices, search.search_radius,
                                    search.depth_tolerance, last.contacts, search.forced},
                                   set.candidates, pool);
    end_of(Phase::detection, times);
    JointSegments segments =
        transfer_contacts(model, last.contacts, search.search_radius, search.first_step, set.contacts);
    const double stress_free_gap_decay =
        search.duration > 0 ? std::exp(-search.duration / stress_free_gap_time) : 0;
    for (Contact& c : set.contacts) {
        initialise_spring(model, stress_free_gap_decay, c);
        const bool is_forced =
            std::binary_search(search.forced.begin(), search.forced.end(), CornerEdge{c.corner, c.edge});
        // A corner enters through a line that it was outside of: one that is open and behind the line belongs
        // elsewhere. Sliding on to a neighbour's face it is as far behind that as it is in the face it
        // leaves.
        if (c.state == ContactState::open &&
            c.gap_to_rock() < -(search.depth_tolerance + 2 * c.inherited_penetration) && !is_forced)
            c.inhibited = true;
    }
    end_of(Phase::transfer, times);
    return {std::move(set), std::move(segments)};
}

}  // namespace rockslope::dda
