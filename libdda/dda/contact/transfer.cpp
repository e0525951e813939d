#include "dda/contact/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"
#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

namespace {

/// How much deeper than its predecessor a contact may be, beyond twice that depth, as a share of the way that
/// contacts move: rounding, and the strain of a step.
constexpr double depth_tolerance = 1e-8;

void copy_state(const Contact& from, Contact& to) {
    to.state = from.state;
    to.normal_force = from.normal_force;
    to.stress_free_gap = from.stress_free_gap;
    to.shear_force = from.shear_force;
    to.slip = from.slip;
    to.bonded = from.bonded;
    to.inherit_history(from.history, from.dilation);
    to.joint = from.joint >= 0 ? from.joint : to.joint;
}

/// Lets a contact that took over from one of another depth bear the same force, without energy from nowhere.
void preserve_force(const Model& model, Contact& contact) {
    if (contact.state == ContactState::open || model.is_augmented(contact.joint_material)) return;
    contact.stress_free_gap = contact.gap + normal_spring(model, contact).closure(contact.normal_force);
}

/// Whether an old contact lay on the line of a new one: the same segments, or the same with corner and edge
/// in exchanged roles, or the same corner on a neighbour's face.
bool same_line(const Contact& from, const Contact& to) {
    if (from.joint_material != to.joint_material) return false;
    const double cosine = from.normal.dot(to.normal);
    const bool same_roles = from.corner_block == to.corner_block && from.edge_block == to.edge_block;
    const bool swapped_roles = from.corner_block == to.edge_block && from.edge_block == to.corner_block;
    const bool next_block = from.corner == to.corner;
    const double least = std::sqrt(1 - parallel_tolerance * parallel_tolerance);
    if ((same_roles || next_block) && cosine > least) return true;
    return swapped_roles && cosine < -least;
}

/// Touching faces of the first configuration: a gap of a millionth of the shared length is rounding, not an
/// open joint.
bool touches(const Contact& contact) {
    return std::abs(contact.gap) <= 1e-6 * std::max(contact.length, 1e-3);
}

void initialise_new(const Model& model, bool first_step, Contact& contact) {
    const JointLaw& law = model.joint_materials[static_cast<std::size_t>(contact.joint_material)].law;
    const bool intact = first_step && touches(contact);
    contact.history = fresh_history(law, intact);
    contact.state = intact ? ContactState::locked : ContactState::open;
    contact.bonded =
        intact && contact.length > 0 && strength(law, contact.history, 0, contact.length).tensile > 0;
}

/// How an old contact is related to a new one: the nearer match_level comes first.
enum class MatchLevel { same_corner, same_blocks, none };
MatchLevel match_level(const Contact& a, const Contact& b) {
    if (a.corner == b.corner) return MatchLevel::same_corner;
    return a.blocks() == b.blocks() ? MatchLevel::same_blocks : MatchLevel::none;
}

/// The old contacts that are no longer, by either of their blocks, so that a new one looks at the few that
/// could be its own.
class PredecessorIndex {
  public:
    PredecessorIndex(std::span<const Contact* const> predecessors, double max_displacement)
        : max_distance_(max_displacement) {
        for (const Contact* predecessor : predecessors) {
            by_block_.emplace_back(predecessor->corner_block, predecessor);
            by_block_.emplace_back(predecessor->edge_block, predecessor);
        }
        std::sort(by_block_.begin(), by_block_.end());
    }

    /// The nearest on the contact's line, so related, that has not matched yet; null if there is none.
    const Contact* nearest(const Contact& contact, MatchLevel level,
                           std::span<const Contact* const> matched) const {
        const Contact* nearest = nullptr;
        double least = max_distance_;
        auto entry = std::lower_bound(by_block_.begin(), by_block_.end(),
                                      std::pair<int, const Contact*>{contact.corner_block, nullptr});
        for (; entry != by_block_.end() && entry->first == contact.corner_block; ++entry) {
            const Contact* predecessor = entry->second;
            const double distance = (predecessor->point - contact.point).norm();
            if (match_level(*predecessor, contact) != level || distance > least ||
                !may_match(*predecessor, contact))
                continue;
            if (std::find(matched.begin(), matched.end(), predecessor) != matched.end()) continue;
            if (nearest == nullptr || distance < least) {
                least = distance;
                nearest = predecessor;
            }
        }
        return nearest;
    }

  private:
    /// The same line has the same gap, and a deeper contact would come with energy from nowhere.
    bool may_match(const Contact& predecessor, const Contact& contact) const {
        const double gap = contact.gap + contact.dilation - predecessor.dilation;
        return same_line(predecessor, contact) &&
               std::abs(predecessor.gap - gap) <= parallel_tolerance * max_distance_ &&
               gap >= 2 * std::min(predecessor.gap, 0.0) - depth_tolerance * max_distance_;
    }

    double max_distance_;
    std::vector<std::pair<int, const Contact*>> by_block_;
};

/// The old contacts that bore a force, by either of their blocks.
class LoadedContacts {
  public:
    LoadedContacts(int blocks, std::span<const Contact> old) : old_(old), by_block_(blocks, blocks_of(old)) {}

    /// The nearest on the contact's line that has a block with it in common, no farther than that; null if
    /// there is none.
    const Contact* nearest(const Contact& contact, double max_distance) const {
        const Contact* nearest = nullptr;
        double least = max_distance;
        for (const int block : {contact.corner_block, contact.edge_block}) {
            for (const int entry_index : by_block_.of(block)) {
                const Contact& loaded = old_[static_cast<std::size_t>(entry_index / 2)];
                if (loaded.state == ContactState::open) continue;
                const double distance = (loaded.point - contact.point).norm();
                if (distance > least || !along(loaded, contact, max_distance)) continue;
                if (nearest == nullptr || distance < least) nearest = &loaded;
                least = distance;
            }
        }
        return nearest;
    }

  private:
    /// Of each contact the two, in turn.
    static std::vector<int> blocks_of(std::span<const Contact> contacts) {
        std::vector<int> blocks;
        blocks.reserve(2 * contacts.size());
        for (const Contact& contact : contacts)
            blocks.insert(blocks.end(), {contact.corner_block, contact.edge_block});
        return blocks;
    }
    static bool along(const Contact& loaded, const Contact& contact, double max_displacement) {
        const double cosine = loaded.normal.dot(contact.normal);
        const bool same_role =
            loaded.corner_block == contact.corner_block || loaded.edge_block == contact.edge_block;
        return loaded.joint_material == contact.joint_material &&
               (same_role ? cosine : -cosine) > std::sqrt(1 - parallel_tolerance * parallel_tolerance) &&
               std::abs(loaded.gap + loaded.dilation - contact.gap - contact.dilation) <=
                   parallel_tolerance * max_displacement;
    }

    std::span<const Contact> old_;
    OwnerIndex by_block_;
};

/// The nearest closed contact of the same blocks on the same line, no farther than that; null if there is
/// none.
Contact* nearest_closed(const Contact& lost, std::span<Contact> contacts, double max_distance) {
    Contact* nearest = nullptr;
    auto c = std::partition_point(contacts.begin(), contacts.end(),
                                  [&](const Contact& other) { return other.blocks() < lost.blocks(); });
    for (; c != contacts.end() && c->blocks() == lost.blocks(); ++c) {
        const double distance = (c->point - lost.point).norm();
        if (c->state == ContactState::open || distance > max_distance || !same_line(lost, *c)) continue;
        max_distance = distance;
        nearest = &*c;
    }
    return nearest;
}

/// A contact that came into being where two rough faces have another has been through what that has.
void share_segment_history(const JointSegments& segments, std::span<char> has_history,
                           std::span<Contact> contacts) {
    const auto has_history_at = [&](int k) -> char& { return has_history[static_cast<std::size_t>(k)]; };
    const auto at = [&](int k) -> Contact& { return contacts[static_cast<std::size_t>(k)]; };
    for (std::size_t f = 0; f < segments.count(); ++f) {
        const Contact* longest = nullptr;
        for (const int k : segments.contacts_of(f)) {
            if (has_history_at(k) != 0 && (longest == nullptr || at(k).length > longest->length))
                longest = &at(k);
        }
        if (longest == nullptr) continue;
        for (const int k : segments.contacts_of(f)) {
            if (has_history_at(k) == 0) at(k).inherit_history(longest->history, longest->dilation);
            has_history_at(k) = 1;
        }
    }
}

}  // namespace

JointSegments transfer_contacts(const Model& model, std::span<const Contact> old, double max_displacement,
                                bool first_step, std::vector<Contact>& contacts) {
    std::vector<char> has_history(contacts.size(), 0);  // what its joint has been through
    std::vector<std::size_t> successors;  // that may take over: those that are new or bear nothing
    successors.reserve(contacts.size());
    std::vector<const Contact*> predecessors;
    auto from = old.begin();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        while (from != old.end() && comes_before(*from, contacts[k])) predecessors.push_back(&*from++);
        if (from != old.end() && !comes_before(contacts[k], *from)) {
            copy_state(*from, contacts[k]);
            has_history[k] = 1;
            if (from->state == ContactState::open) successors.push_back(k);
            ++from;
        } else {
            initialise_new(model, first_step, contacts[k]);
            successors.push_back(k);
        }
    }
    while (from != old.end()) predecessors.push_back(&*from++);

    const PredecessorIndex predecessor_index(predecessors, max_displacement);
    std::vector<const Contact*> matched;
    // A corner takes what it bears with it on to the next face; what is left goes to the blocks' other
    // contacts. One that bears nothing leaves those that were there what they have been through.
    for (const MatchLevel level : {MatchLevel::same_corner, MatchLevel::same_blocks}) {
        for (const std::size_t k : successors) {
            if (contacts[k].state != ContactState::open) continue;
            const Contact* predecessor = predecessor_index.nearest(contacts[k], level, matched);
            if (predecessor == nullptr || (has_history[k] != 0 && predecessor->state == ContactState::open))
                continue;
            copy_state(*predecessor, contacts[k]);
            has_history[k] = 1;
            preserve_force(model, contacts[k]);
            matched.push_back(predecessor);
        }
    }
    // One that ends beside another of the two blocks leaves its force to that, as far as the other has sunk.
    for (const Contact* predecessor : predecessors) {
        if (predecessor->state == ContactState::open ||
            std::find(matched.begin(), matched.end(), predecessor) != matched.end())
            continue;
        Contact* other = nearest_closed(*predecessor, contacts, max_displacement);
        if (other == nullptr || model.is_augmented(other->joint_material)) continue;
        const NormalClosure spring = normal_spring(model, *other);
        const double added_closure = spring.closure(other->normal_force + predecessor->normal_force) -
                                     spring.closure(other->normal_force);
        other->stress_free_gap =
            std::max(other->stress_free_gap, std::min(other->stress_free_gap + added_closure, 0.0));
    }
    // Where a corner slides on to a neighbour's face and the end of the overlap that it leaves has a corner
    // of its own, one contact becomes two: the second knows the joint, and bears nothing until it gets
    // deeper. While it waits for that in a face that others bear, it goes on to know what they do. Rough
    // faces know better what they have been through themselves.
    JointSegments segments(model, contacts);
    share_segment_history(segments, has_history, contacts);
    std::optional<LoadedContacts> loaded_contacts;
    for (const std::size_t k : successors) {
        Contact& contact = contacts[k];
        const bool is_passive = contact.inherited_penetration > 0 && contact.slip == 0;
        if (contact.state != ContactState::open || !is_passive) continue;
        if (has_history[k] != 0 && has_segment_history(model.joint_material_at(contact.joint_material).law))
            continue;
        if (!loaded_contacts) loaded_contacts.emplace(model.block_count(), old);
        const Contact* loaded = loaded_contacts->nearest(contact, max_displacement);
        if (loaded == nullptr) continue;
        contact.inherit_history(loaded->history, loaded->dilation);
        has_history[k] = 1;
    }
    share_segment_history(segments, has_history, contacts);
    return segments;
}

}  // namespace rockslope::dda
