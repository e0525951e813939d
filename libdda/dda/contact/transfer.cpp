#include "dda/contact/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "common/base/parallel_filter.hpp"
#include "common/base/parallel_parts.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"
#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

namespace {

/// A contact may be twice as deep as its predecessor, plus this fraction of the largest displacement for
/// rounding and the strain of a step.
constexpr double depth_tolerance_ratio = 1e-8;

/// Copies state, forces, slip and history of a predecessor, and with the history the joint whose law it is.
void copy_state(const Contact& from, Contact& to) {
    to.state = from.state;
    to.normal_force = from.normal_force;
    to.normal_spring_force = from.normal_spring_force;
    to.stress_free_gap = from.stress_free_gap;
    to.shear_force = from.shear_force;
    to.slip = from.slip;
    to.bonded = from.bonded;
    to.bond_strain = from.bond_strain;
    to.joint_material = from.joint_material;
    to.inherit_history(from.history, from.dilation);
    to.joint = from.joint >= 0 ? from.joint : to.joint;
}

/// Sets the stress-free gap at which a contact bears its predecessor's force at its own gap: transfer adds no
/// energy.
void preserve_force(const Model& model, Contact& contact) {
    if (contact.state == ContactState::open || model.is_augmented(contact.joint_material)) return;
    contact.stress_free_gap =
        contact.gap + normal_spring(model, contact).closure(contact.normal_spring_force);
}

/// Whether an old contact lay on the line of a new one: it has the same blocks, or the same blocks with
/// corner and edge exchanged, or the same corner on a neighbouring block's face.
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

/// Whether faces touch in the first configuration, Eq. (30). A smaller gap is rounding, not an open joint.
bool touches(const Contact& contact) {
    constexpr double closed_gap = 1e-6;    // of the shared length
    constexpr double least_length = 1e-3;  // m
    return std::abs(contact.gap) <= closed_gap * std::max(contact.length, least_length);
}

/// Sets the state of a contact without predecessor.
void initialise_new(const Model& model, bool first_step, Contact& contact) {
    const JointLaw& law = model.joint_materials[contact.joint_material].law;
    const bool intact = first_step && touches(contact);
    contact.history = fresh_history(law, intact);
    contact.state = intact ? ContactState::locked : ContactState::open;
    contact.bonded =
        intact && contact.length > 0 && strength(law, contact.history, 0, contact.length).tensile > 0;
}

/// Kinds of match of an old contact with a new one, in the order in which they are tried.
enum class MatchLevel { same_corner, same_blocks, none };
MatchLevel match_level(const Contact& a, const Contact& b) {
    if (a.corner == b.corner) return MatchLevel::same_corner;
    return a.blocks() == b.blocks() ? MatchLevel::same_blocks : MatchLevel::none;
}

/// The old contacts whose (corner, edge) pair is gone, sorted by each of their two blocks.
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

    /// Whether a block has a predecessor.
    bool has_any(BlockIndex block) const {
        const auto entry = first_of(block);
        return entry != by_block_.end() && entry->first == block;
    }

    /// The nearest predecessor of a contact, of the given match level, not in `matched`; null if there is
    /// none.
    const Contact* nearest(const Contact& contact, MatchLevel level,
                           std::span<const Contact* const> matched) const {
        const Contact* nearest = nullptr;
        double least = max_distance_;
        auto entry = first_of(contact.corner_block);
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
    std::vector<std::pair<BlockIndex, const Contact*>>::const_iterator first_of(BlockIndex block) const {
        return std::lower_bound(by_block_.begin(), by_block_.end(),
                                std::pair<BlockIndex, const Contact*>{block, nullptr});
    }

    /// Whether both are on one line with about the same gap. A deeper contact would add energy.
    bool may_match(const Contact& predecessor, const Contact& contact) const {
        const double gap = contact.gap + contact.dilation - predecessor.dilation;
        return same_line(predecessor, contact) &&
               std::abs(predecessor.gap - gap) <= parallel_tolerance * max_distance_ &&
               gap >= 2 * std::min(predecessor.gap, 0.0) - depth_tolerance_ratio * max_distance_;
    }

    double max_distance_;
    std::vector<std::pair<BlockIndex, const Contact*>> by_block_;
};

/// The old contacts, indexed by each of their two blocks, to find the loaded (closed) ones near a contact.
class LoadedContacts {
  public:
    LoadedContacts(std::size_t blocks, ContactSpan<const Contact> old)
        : old_(old), by_block_(blocks, blocks_of(old)) {}

    /// The nearest closed contact on the line of `contact` that shares a block with it, at most
    /// `max_distance` away; null if there is none.
    const Contact* nearest(const Contact& contact, double max_distance) const {
        const Contact* nearest = nullptr;
        double least = max_distance;
        for (const BlockIndex block : {contact.corner_block, contact.edge_block}) {
            for (const std::uint32_t entry_index : by_block_.of(block)) {
                const Contact& loaded = old_[entry_index / 2];
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
    /// Both blocks of each contact: entries 2k and 2k + 1 are contact k's.
    static std::vector<BlockIndex> blocks_of(ContactSpan<const Contact> contacts) {
        std::vector<BlockIndex> blocks;
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

    ContactSpan<const Contact> old_;
    OwnerIndex<BlockIndex, std::uint32_t> by_block_;
};

/// The nearest closed contact of the same blocks on the same line, at most `max_distance` away; null if there
/// is none.
Contact* nearest_closed(const Contact& lost, ContactSpan<Contact> contacts, double max_distance) {
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

/// Contacts without a history inherit that of the longest contact of their joint segment that has one.
void share_segment_history(const JointSegments& segments, std::span<char> has_history,
                           ContactSpan<Contact> contacts) {
    for (std::size_t segment = 0; segment < segments.count(); ++segment) {
        const Contact* longest = nullptr;
        for (const ContactIndex k : segments.contacts_of(segment)) {
            if (has_history[k] != 0 && (longest == nullptr || contacts[k].length > longest->length))
                longest = &contacts[k];
        }
        if (longest == nullptr) continue;
        for (const ContactIndex k : segments.contacts_of(segment)) {
            if (has_history[k] == 0) contacts[k].inherit_history(longest->history, longest->dilation);
            has_history[k] = 1;
        }
    }
}

/// Carries the contacts of one step over to those of the next, in the order of the functions.
class Transfer {
  public:
    Transfer(const Model& model, ContactSpan<const Contact> old, double max_displacement,
             std::vector<Contact>& contacts)
        : model_(model),
          old_(old),
          max_displacement_(max_displacement),
          contacts_(contacts),
          has_history_(contacts.size(), 0) {}

    /// Matches by corner and edge.
    void match_pairs(bool first_step, const ThreadPool& pool) {
        std::vector<Unmatched> parts = parallel_parts(
            pool, contacts_.size(),
            [&](std::size_t begin, std::size_t end) { return match_pairs(begin, end, first_step); });
        predecessors_ = std::move(parts.front().predecessors);
        successors_ = std::move(parts.front().successors);
        for (const Unmatched& more : std::span(parts).subspan(1)) {
            append(predecessors_, more.predecessors);
            append(successors_, more.successors);
        }
    }

    /// Matches by line: predecessors with the same corner first, then those of the same blocks. An open
    /// predecessor does not replace the history of a contact that existed.
    void match_lines(const ThreadPool& pool) {
        const PredecessorIndex predecessor_index(predecessors_, max_displacement_);
        const std::vector<std::size_t> beside = select_successors(
            pool, [&](std::size_t k) { return predecessor_index.has_any(contacts_[k].corner_block); });
        for (const MatchLevel level : {MatchLevel::same_corner, MatchLevel::same_blocks}) {
            for (const std::size_t k : beside) {
                if (contacts_[k].state != ContactState::open) continue;
                const Contact* predecessor = predecessor_index.nearest(contacts_[k], level, matched_);
                if (predecessor == nullptr ||
                    (has_history_[k] != 0 && predecessor->state == ContactState::open))
                    continue;
                copy_state(*predecessor, contacts_[k]);
                has_history_[k] = 1;
                preserve_force(model_, contacts_[k]);
                matched_.push_back(predecessor);
            }
        }
    }

    /// A predecessor without successor leaves its normal force to the nearest closed contact of the same
    /// blocks: the stress-free gap of that contact rises, at most to zero.
    void leave_normal_forces() {
        for (const Contact* predecessor : predecessors_) {
            if (predecessor->state == ContactState::open ||
                std::find(matched_.begin(), matched_.end(), predecessor) != matched_.end())
                continue;
            Contact* other = nearest_closed(*predecessor, contacts_, max_displacement_);
            if (other == nullptr || model_.is_augmented(other->joint_material)) continue;
            const NormalClosure spring = normal_spring(model_, *other);
            const double added_closure =
                spring.closure(other->normal_spring_force + predecessor->normal_spring_force) -
                spring.closure(other->normal_spring_force);
            other->stress_free_gap =
                std::max(other->stress_free_gap, std::min(other->stress_free_gap + added_closure, 0.0));
        }
    }

    /// One contact becomes two where a corner slides onto a neighbour's face and the end of the overlap that
    /// it leaves has a corner. The second contact inherits the history of the joint, and bears no force until
    /// it gets deeper. Until then it follows the history of the loaded contacts beside it. A contact of a
    /// rough joint that has a history keeps the one of its segment.
    JointSegments inherit_histories(const ThreadPool& pool) {
        JointSegments segments(model_, contacts_);
        share_segment_history(segments, has_history_, contacts_);
        const std::vector<std::size_t> passive = select_successors(pool, [&](std::size_t k) {
            return is_passive(contacts_[k]) && (has_history_[k] == 0 || !has_segment_history(law_of(k)));
        });
        if (!passive.empty()) inherit_from_loaded(passive, pool);
        share_segment_history(segments, has_history_, contacts_);
        return segments;
    }

  private:
    struct Unmatched {
        std::vector<const Contact*> predecessors;
        std::vector<std::size_t> successors;
    };

    /// Matches the contacts [begin, end) with the old ones in their place.
    Unmatched match_pairs(std::size_t begin, std::size_t end, bool first_step) {
        const auto place_of = [&](std::size_t k) {
            return k == contacts_.size() ? old_.end()
                                         : std::partition_point(old_.begin(), old_.end(), [&](auto& other) {
                                               return comes_before(other, contacts_[k]);
                                           });
        };
        Unmatched unmatched;
        unmatched.successors.reserve(end - begin);
        auto from = begin == 0 ? old_.begin() : place_of(begin);
        const auto last = place_of(end);
        for (std::size_t k = begin; k < end; ++k) {
            while (from != last && comes_before(*from, contacts_[k]))
                unmatched.predecessors.push_back(&*from++);
            const bool has_pair = from != last && !comes_before(contacts_[k], *from);
            if (!has_pair || from->state == ContactState::open) unmatched.successors.push_back(k);
            has_history_[k] = has_pair ? 1 : 0;
            if (has_pair)
                copy_state(*from++, contacts_[k]);
            else
                initialise_new(model_, first_step, contacts_[k]);
        }
        while (from != last) unmatched.predecessors.push_back(&*from++);
        return unmatched;
    }

    /// Contacts inherit the history of the nearest loaded contact beside them.
    void inherit_from_loaded(std::span<const std::size_t> passive, const ThreadPool& pool) {
        const LoadedContacts loaded_contacts(model_.block_count(), old_);
        std::vector<const Contact*> loaded(passive.size());
        pool.parallel_for(passive.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                loaded[i] = loaded_contacts.nearest(contacts_[passive[i]], max_displacement_);
        });
        for (std::size_t i = 0; i < passive.size(); ++i) {
            if (loaded[i] == nullptr) continue;
            contacts_[passive[i]].inherit_history(loaded[i]->history, loaded[i]->dilation);
            has_history_[passive[i]] = 1;
        }
    }

    const JointLaw& law_of(std::size_t k) const {
        return model_.joint_material_at(contacts_[k].joint_material).law;
    }

    /// The successors that fulfil a condition, ascending.
    template <class Condition>
    std::vector<std::size_t> select_successors(const ThreadPool& pool, const Condition& condition) const {
        std::vector<std::size_t> selected = parallel_filter(
            pool, successors_.size(), [&](std::size_t i) { return condition(successors_[i]); });
        for (std::size_t& k : selected) k = successors_[k];
        return selected;
    }

    static bool is_passive(const Contact& contact) {
        return contact.state == ContactState::open && contact.inherited_penetration > 0 && contact.slip == 0;
    }

    const Model& model_;
    ContactSpan<const Contact> old_;
    double max_displacement_;
    std::vector<Contact>& contacts_;
    std::vector<char> has_history_;             ///< per contact, whether its history is set
    std::vector<std::size_t> successors_;       ///< new and open contacts: may continue another
    std::vector<const Contact*> predecessors_;  ///< old contacts whose pair is gone
    std::vector<const Contact*> matched_;       ///< predecessors that a contact continues
};

}  // namespace

JointSegments transfer_contacts(const Model& model, ContactSpan<const Contact> old, double max_displacement,
                                bool first_step, std::vector<Contact>& contacts, const ThreadPool& pool) {
    Transfer transfer(model, old, max_displacement, contacts);
    transfer.match_pairs(first_step, pool);
    transfer.match_lines(pool);
    transfer.leave_normal_forces();
    return transfer.inherit_histories(pool);
}

}  // namespace rockslope::dda
