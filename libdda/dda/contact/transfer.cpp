#include "dda/contact/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dda/contact/by_owner.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"

namespace dda {

namespace {

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
    to.take_history(from.history, from.dilation);
    to.joint = from.joint >= 0 ? from.joint : to.joint;
}

/// Lets a contact that took over from one of another depth bear the same force, without energy from nowhere.
void keep_force(const Model& model, Contact& contact) {
    if (contact.state == ContactState::open || model.augments(contact.joint_material)) return;
    contact.rest_gap = contact.gap + normal_spring(model, contact).closure(contact.normal_force);
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

/// How an old contact is related to a new one: the nearer relation comes first.
enum class Kin { same_corner, same_blocks, none };
Kin relation(const Contact& a, const Contact& b) {
    if (a.corner == b.corner) return Kin::same_corner;
    return a.blocks() == b.blocks() ? Kin::same_blocks : Kin::none;
}

/// The old contacts that are no longer, by either of their blocks, so that a new one looks at the few that
/// could be its own.
class Estate {
  public:
    Estate(std::span<const Contact* const> donors, double moved) : moved_(moved) {
        for (const Contact* donor : donors) {
            by_block_.emplace_back(donor->corner_block, donor);
            by_block_.emplace_back(donor->edge_block, donor);
        }
        std::sort(by_block_.begin(), by_block_.end());
    }

    /// The nearest on the contact's line, so related, that has not given yet; null if there is none.
    const Contact* nearest(const Contact& contact, Kin kin, std::span<const Contact* const> given) const {
        const Contact* nearest = nullptr;
        double least = moved_;
        auto entry = std::lower_bound(by_block_.begin(), by_block_.end(),
                                      std::pair<int, const Contact*>{contact.corner_block, nullptr});
        for (; entry != by_block_.end() && entry->first == contact.corner_block; ++entry) {
            const Contact* donor = entry->second;
            const double distance = (donor->point - contact.point).norm();
            if (relation(*donor, contact) != kin || distance > least || !may_give(*donor, contact)) continue;
            if (std::find(given.begin(), given.end(), donor) != given.end()) continue;
            if (nearest == nullptr || distance < least) {
                least = distance;
                nearest = donor;
            }
        }
        return nearest;
    }

  private:
    /// The same line has the same gap, and a deeper contact would come with energy from nowhere.
    bool may_give(const Contact& donor, const Contact& contact) const {
        const double gap = contact.gap + contact.dilation - donor.dilation;
        return same_line(donor, contact) && std::abs(donor.gap - gap) <= parallel_tolerance * moved_ &&
               gap >= 2 * std::min(donor.gap, 0.0) - same_depth * moved_;
    }

    double moved_;
    std::vector<std::pair<int, const Contact*>> by_block_;
};

/// The old contacts that bore a force, by either of their blocks.
class Bearers {
  public:
    Bearers(int blocks, std::span<const Contact> old) : old_(old), by_block_(blocks, blocks_of(old)) {}

    /// The nearest on the contact's line that has a block with it in common, no farther than that; null if
    /// there is none.
    const Contact* nearest(const Contact& contact, double farthest) const {
        const Contact* nearest = nullptr;
        double least = farthest;
        for (const int block : {contact.corner_block, contact.edge_block}) {
            for (const int mention : by_block_.of(block)) {
                const Contact& bearer = old_[static_cast<std::size_t>(mention / 2)];
                if (bearer.state == ContactState::open) continue;
                const double distance = (bearer.point - contact.point).norm();
                if (distance > least || !along(bearer, contact, farthest)) continue;
                if (nearest == nullptr || distance < least) nearest = &bearer;
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
    static bool along(const Contact& bearer, const Contact& contact, double moved) {
        const double facing = bearer.normal.dot(contact.normal);
        const bool same_role =
            bearer.corner_block == contact.corner_block || bearer.edge_block == contact.edge_block;
        return bearer.joint_material == contact.joint_material &&
               (same_role ? facing : -facing) > std::sqrt(1 - parallel_tolerance * parallel_tolerance) &&
               std::abs(bearer.gap + bearer.dilation - contact.gap - contact.dilation) <=
                   parallel_tolerance * moved;
    }

    std::span<const Contact> old_;
    ByOwner by_block_;
};

/// The nearest closed contact of the same blocks on the same line, no farther than that; null if there is
/// none.
Contact* beside(const Contact& gone, std::span<Contact> contacts, double farthest) {
    Contact* nearest = nullptr;
    auto c = std::partition_point(contacts.begin(), contacts.end(),
                                  [&](const Contact& other) { return other.blocks() < gone.blocks(); });
    for (; c != contacts.end() && c->blocks() == gone.blocks(); ++c) {
        const double distance = (c->point - gone.point).norm();
        if (c->state == ContactState::open || distance > farthest || !same_line(gone, *c)) continue;
        farthest = distance;
        nearest = &*c;
    }
    return nearest;
}

/// A contact that came into being where two rough faces have another has been through what that has.
void tell_faces(const JointFaces& faces, std::span<char> knows, std::span<Contact> contacts) {
    const auto known = [&](int k) -> char& { return knows[static_cast<std::size_t>(k)]; };
    const auto at = [&](int k) -> Contact& { return contacts[static_cast<std::size_t>(k)]; };
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const Contact* longest = nullptr;
        for (const int k : faces.contacts_of(f)) {
            if (known(k) != 0 && (longest == nullptr || at(k).length > longest->length)) longest = &at(k);
        }
        if (longest == nullptr) continue;
        for (const int k : faces.contacts_of(f)) {
            if (known(k) == 0) at(k).take_history(longest->history, longest->dilation);
            known(k) = 1;
        }
    }
}

}  // namespace

JointFaces transfer_contacts(const Model& model, std::span<const Contact> old, double moved, bool first_step,
                             std::vector<Contact>& contacts) {
    std::vector<char> knows(contacts.size(), 0);  // what its joint has been through
    std::vector<std::size_t> heirs;               // that may take over: those that are new or bear nothing
    heirs.reserve(contacts.size());
    std::vector<const Contact*> donors;
    auto from = old.begin();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        while (from != old.end() && comes_before(*from, contacts[k])) donors.push_back(&*from++);
        if (from != old.end() && !comes_before(contacts[k], *from)) {
            hand_over(*from, contacts[k]);
            knows[k] = 1;
            if (from->state == ContactState::open) heirs.push_back(k);
            ++from;
        } else {
            start_fresh(model, first_step, contacts[k]);
            heirs.push_back(k);
        }
    }
    while (from != old.end()) donors.push_back(&*from++);

    const Estate estate(donors, moved);
    std::vector<const Contact*> given;
    // A corner takes what it bears with it on to the next face; what is left goes to the blocks' other
    // contacts. One that bears nothing leaves those that were there what they have been through.
    for (const Kin kin : {Kin::same_corner, Kin::same_blocks}) {
        for (const std::size_t k : heirs) {
            if (contacts[k].state != ContactState::open) continue;
            const Contact* donor = estate.nearest(contacts[k], kin, given);
            if (donor == nullptr || (knows[k] != 0 && donor->state == ContactState::open)) continue;
            hand_over(*donor, contacts[k]);
            knows[k] = 1;
            keep_force(model, contacts[k]);
            given.push_back(donor);
        }
    }
    // One that ends beside another of the two blocks leaves its force to that, as far as the other has sunk.
    for (const Contact* donor : donors) {
        if (donor->state == ContactState::open || std::find(given.begin(), given.end(), donor) != given.end())
            continue;
        Contact* other = beside(*donor, contacts, moved);
        if (other == nullptr || model.augments(other->joint_material)) continue;
        const NormalClosure spring = normal_spring(model, *other);
        const double deeper =
            spring.closure(other->normal_force + donor->normal_force) - spring.closure(other->normal_force);
        other->rest_gap = std::max(other->rest_gap, std::min(other->rest_gap + deeper, 0.0));
    }
    // Where a corner slides on to a neighbour's face and the end of the overlap that it leaves has a corner
    // of its own, one contact becomes two: the second knows the joint, and bears nothing until it gets
    // deeper. While it waits for that in a face that others bear, it goes on to know what they do. Rough
    // faces know better what they have been through themselves.
    JointFaces faces(model, contacts);
    tell_faces(faces, knows, contacts);
    std::optional<Bearers> bearers;
    for (const std::size_t k : heirs) {
        Contact& contact = contacts[k];
        const bool waits = contact.known_depth > 0 && contact.slip == 0;
        if (contact.state != ContactState::open || !waits) continue;
        if (knows[k] != 0 && belongs_to_faces(model.joint_material_at(contact.joint_material).law)) continue;
        if (!bearers) bearers.emplace(model.block_count(), old);
        const Contact* bearer = bearers->nearest(contact, moved);
        if (bearer == nullptr) continue;
        contact.take_history(bearer->history, bearer->dilation);
        knows[k] = 1;
    }
    tell_faces(faces, knows, contacts);
    return faces;
}

}  // namespace dda
