#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/contact/owner_index.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The depth that a contact stands for, m: it bears force at that depth, or its corner was let on to the edge
/// about as deep (Contact::inherited_penetration) and it bears what comes on top. Where the corner has slid
/// past the edge's end it is the depth of that end behind the face of the corner that now lies over it.
/// Nothing if the contact stands for none.
/// @param vertices at the contact's instant.
std::optional<double> penetration_accounted_for(const Topology& topology, std::span<const Vec2> vertices,
                                                const Contact& contact);

/// How deep corners are in what bears them, or would if they got deeper. A contact tells it of its corner,
/// and of the end of its edge where that is within search_radius of the corner: of two corners on each other
/// only one has a contact.
class InheritedPenetrations {
  public:
    /// @param vertices, contacts at the same instant; the contacts outlive this; @param search_radius m, see
    /// detect_contacts.
    InheritedPenetrations(const Topology& topology, std::span<const Vec2> vertices,
                          std::span<const Contact> contacts, double search_radius);

    /// The depth, m, of a corner in faces that lie along a line with that normal, which points away from the
    /// face's rock; 0 where nothing bears it. A corner that slides from one block's face onto its neighbour's
    /// is as deep in the second, when it gets there, as it was in the first: that depth is no reason to think
    /// that it came through another face.
    double along(int corner, const Vec2& normal) const;
    /// Likewise in a block, whatever the face. An augmented contact tells of what its spring gives, if that
    /// is more.
    double in_block(int corner, int block) const;

  private:
    struct Entry {
        int contact = 0;          ///< that tells of it
        int block = 0;            ///< whose face bears it
        double depth = 0;         ///< m
        double spring_depth = 0;  ///< m, by which the contact's spring is compressed
    };
    struct Found;
    InheritedPenetrations(std::span<const Contact> contacts, int corners, Found found);
    static Found find(const Topology& topology, std::span<const Vec2> vertices,
                      std::span<const Contact> contacts, double search_radius);
    const Entry& entry(int k) const { return entries_[static_cast<std::size_t>(k)]; }
    /// Of the face that bears it, away from its rock.
    Vec2 normal_of(const Entry& entry) const {
        const Contact& contact = contacts_[static_cast<std::size_t>(entry.contact)];
        return entry.block == contact.edge_block ? contact.normal : Vec2(-contact.normal);
    }

    std::span<const Contact> contacts_;
    std::vector<Entry> entries_;
    OwnerIndex by_corner_;
};

}  // namespace rockslope::dda
