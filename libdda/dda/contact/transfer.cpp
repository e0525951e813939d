#include "dda/contact/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "dda/contact/detect.hpp"

namespace dda {

namespace {

auto sort_key(const Contact& c) {
    return std::tuple(c.corner_block, c.edge_block, c.corner, c.edge);
}

/// How much deeper than its donor a contact may be, beyond twice that depth, as a share of the way that
/// contacts move: rounding, and the strain of a step.
constexpr double same_depth = 1e-8;

void hand_over(const Contact& from, Contact& to) {
    to.state = from.state;
    to.normal_force = from.normal_force;
    to.rest_gap = from.rest_gap;
    to.shear_force = from.shear_force;
    to.slip = from.slip;
    to.bonded = from.bonded;
    to.history = from.history;
    to.joint = from.joint >= 0 ? from.joint : to.joint;
}

/// Whether an old contact lay on the line of a new one: the same faces, or the same with corner and edge in
/// exchanged roles, or the same corner on a neighbour's face.
bool same_line(const Contact& from, const Contact& to) {
    if (from.joint_material != to.joint_material) return false;
    const double facing = from.normal.dot(to.normal);
    const bool same_roles = from.corner_block == to.corner_block && from.edge_block == to.edge_block;
    const bool exchanged = from.corner_block == to.edge_block && from.edge_block == to.corner_block;
    const bool next_block = from.corner == to.corner;
    const double least = std::sqrt(1 - parallel_tolerance * parallel_tolerance);
    if ((same_roles || next_block) && facing > least) return true;
    return exchanged && facing < -least;
}

/// Touching faces of the first configuration: a gap of a millionth of the shared length is rounding, not an
/// open joint.
bool touches(const Contact& contact) {
    return std::abs(contact.gap) <= 1e-6 * std::max(contact.length, 1e-3);
}

void start_fresh(const Model& model, bool first_step, Contact& contact) {
    const JointLaw& law = model.joint_materials[static_cast<std::size_t>(contact.joint_material)].law;
    const bool intact = first_step && touches(contact);
    contact.history = fresh_history(law, intact);
    contact.state = intact ? ContactState::locked : ContactState::open;
    contact.bonded =
        intact && contact.length > 0 && strength(law, contact.history, 0, contact.length).tensile > 0;
}

}  // namespace

void transfer_contacts(const Model& model, std::span<const Contact> old, double moved, bool first_step,
                       std::vector<Contact>& contacts) {
    std::vector<std::size_t> orphans;
    std::vector<const Contact*> donors;
    auto from = old.begin();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        while (from != old.end() && sort_key(*from) < sort_key(contacts[k])) donors.push_back(&*from++);
        if (from != old.end() && sort_key(*from) == sort_key(contacts[k])) {
            hand_over(*from++, contacts[k]);
        } else {
            orphans.push_back(k);
        }
    }
    while (from != old.end()) donors.push_back(&*from++);

    // Donors by either block, so that an orphan looks at the few that could be its own.
    std::vector<std::pair<int, const Contact*>> by_block;
    for (const Contact* donor : donors) {
        by_block.emplace_back(donor->corner_block, donor);
        by_block.emplace_back(donor->edge_block, donor);
    }
    std::sort(by_block.begin(), by_block.end());
    std::vector<const Contact*> given;
    for (const std::size_t k : orphans) {
        Contact& contact = contacts[k];
        const Contact* nearest = nullptr;
        double least = moved;
        auto entry = std::lower_bound(by_block.begin(), by_block.end(),
                                      std::pair<int, const Contact*>{contact.corner_block, nullptr});
        for (; entry != by_block.end() && entry->first == contact.corner_block; ++entry) {
            const Contact* donor = entry->second;
            const double distance = (donor->point - contact.point).norm();
            if (distance > least || !same_line(*donor, contact)) continue;
            // The same line has the same gap, and a deeper contact would come with energy from nowhere.
            if (std::abs(donor->gap - contact.gap) > parallel_tolerance * moved) continue;
            if (contact.gap < 2 * std::min(donor->gap, 0.0) - same_depth * moved) continue;
            if (std::find(given.begin(), given.end(), donor) != given.end()) continue;
            if (nearest == nullptr || distance < least) {
                least = distance;
                nearest = donor;
            }
        }
        start_fresh(model, first_step, contact);
        if (nearest != nullptr) {
            hand_over(*nearest, contact);
            given.push_back(nearest);
        }
    }
}

}  // namespace dda
