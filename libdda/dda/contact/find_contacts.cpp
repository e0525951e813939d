#include "dda/contact/find_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/contact/candidates.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"
#include "dda/contact/glued_points.hpp"
#include "dda/contact/transfer.hpp"

namespace rockslope::dda {

namespace {

/// Smallest candidate distance over the median edge length, Eq. (25): nearly all of it is skin. Normally 0.1
/// to 0.5. A larger value searches less often and finds more candidates.
constexpr double skin_ratio = 0.25;
/// s, time in which the stress-free gap of a contact decays by the factor e, Eq. (29). Without a decay a
/// block would sink deeper with every face that it slides onto. An instant decay would shake the blocks and,
/// in sliding to and fro, pump energy into them. A static stage has no time, so there it does not decay.
constexpr double stress_free_gap_time = 5;

/// Largest displacement of a corner since the candidates were found, m; infinity if there are none.
double displacement_since(const ContactSet& last, CornerSpan<const Vec2> vertices) {
    if (last.reference.size() != vertices.size()) return std::numeric_limits<double>::infinity();
    double moved = 0;
    for (const CornerIndex k : vertices.indices())
        moved = std::max(moved, (vertices[k] - last.reference[k]).norm());
    return moved;
}

/// A set without contacts. Its candidates contain all pairs within the search radius.
ContactSet find_or_keep_candidates(const Model& model, const ContactSet& last, const ContactSearch& search) {
    ContactSet set;
    // Whether the candidates are still complete, Eq. (26).
    if (search.search_radius.largest() + 2 * displacement_since(last, search.vertices) <=
        last.candidate_distance) {
        set.candidates = last.candidates;
        set.candidate_distance = last.candidate_distance;
        set.reference = last.reference;
    } else {
        // The distance of candidates, Eq. (25).
        set.candidate_distance =
            std::max(skin_ratio * search.edge_length, 2 * search.search_radius.largest());
        set.candidates = find_candidates(model, search.vertices, set.candidate_distance);
        set.reference.assign(search.vertices.begin(), search.vertices.end());
        GluedPoints(model, last.contacts).remove_from(set.candidates);
    }
    return set;
}

/// N per metre
double tensile_strength(const Model& model, const Contact& contact) {
    const JointLaw& law = model.joint_material_at(contact.joint_material).law;
    return strength(law, contact.history, 0, contact.length).tensile;
}

/// Whether a bond holds a contact at a gap that it opened by in a static stage, Eq. (96).
bool is_held_open(const Model& model, const Contact& contact) {
    if (!(contact.stress_free_gap > 0)) return false;
    const JointLaw& law = model.joint_material_at(contact.joint_material).law;
    return strength(law, contact.history, 0, contact.length).forward > 0;
}

/// Sets the stress-free gap of a contact and its normal force at the start of the step, that of its spring
/// alone. Where the normal force differs from that at the last step's end, because the dilation was left to
/// this step, the gap decays or the dashpot bore a part, the shear force follows it, Eq. (77).
void initialise_spring(const Model& model, double stress_free_gap_decay, Contact& contact) {
    // An open contact inside the rock is stress-free at its present gap, so that its spring stores no energy.
    if (contact.state == ContactState::open)
        contact.stress_free_gap = std::min(contact.gap, 0.0);
    else if (!model.is_augmented(contact.joint_material) && !is_held_open(model, contact))
        contact.stress_free_gap *= stress_free_gap_decay;
    const double spring = normal_spring(model, contact).force(contact.stress_free_gap - contact.gap);
    const double force = contact.bonded ? std::max(spring, -tensile_strength(model, contact)) : spring;
    const double before = contact.normal_force;
    contact.normal_force = contact.state != ContactState::open && (force > 0 || contact.bonded) ? force : 0;
    contact.normal_spring_force = contact.normal_force;
    if (contact.state == ContactState::open || contact.normal_force == before) return;
    contact.shear_force += (contact.normal_force - before) *
                           locked_dilation(model, contact.joint_material, contact.history).slope;
}

/// Whether an open contact is behind its line: a corner can enter only through a line that it is outside of,
/// unless the depth is inherited from the face that the corner slides off.
bool is_behind_its_line(const ContactSearch& search, const Contact& c) {
    return c.state == ContactState::open &&
           c.gap_to_rock() < -(search.depth_tolerance + 2 * c.inherited_penetration) &&
           !std::binary_search(search.forced.begin(), search.forced.end(), CornerEdge{c.corner, c.edge});
}

}  // namespace

FoundContacts find_contacts(const Model& model, const ContactSet& last, const ContactSearch& search,
                            const ThreadPool& pool, PhaseTimes* times) {
    ContactSet set = find_or_keep_candidates(model, last, search);
    const auto detect = [&] {
        set.contacts = detect_contacts(model,
                                       {search.vertices, search.mid_step_vertices, search.search_radius,
                                        search.depth_tolerance, last.contacts, search.forced},
                                       set.candidates, pool);
        end_of(Phase::detection, times);
        return transfer_contacts(model, last.contacts, search.search_radius.largest(), search.first_step,
                                 set.contacts, pool);
    };
    JointSegments segments = detect();
    if (search.first_step) {
        // Only now it is known what is glued.
        const GluedPoints glued(model, set.contacts);
        glued.remove_from(set.candidates);
        if (!glued.empty()) segments = detect();
    }
    // Decay of the stress-free gap, Eq. (29).
    const double stress_free_gap_decay = std::exp(-search.duration / stress_free_gap_time);
    pool.parallel_for(set.contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            initialise_spring(model, stress_free_gap_decay, set.contacts[k]);
            if (is_behind_its_line(search, set.contacts[k])) set.contacts[k].inhibited = true;
        }
    });
    end_of(Phase::transfer, times);
    return {std::move(set), std::move(segments)};
}

}  // namespace rockslope::dda
