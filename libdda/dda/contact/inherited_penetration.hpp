#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/contact/owner_index.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Depth of a corner in a face that a contact accounts for, m; nothing if it accounts for none. A closed
/// contact accounts for its penetration. An inhibited one accounts for none. Any other open contact accounts
/// for its corner's depth up to twice Contact::inherited_penetration. If the corner has slid past the end of
/// the edge, the depth is that of the edge's end behind the corner's face.
/// @param vertices per corner, at the time of the contact, m.
std::optional<double> penetration_accounted_for(const Topology& topology, CornerSpan<const Vec2> vertices,
                                                const Contact& contact);

/// The penetration of each corner that contacts account for. It is not evidence that a corner entered through
/// another edge. A contact accounts for its corner, and for the ends of its edge within the search radius of
/// the corner: where two corners meet, only one of them has a contact. It also accounts for the corners next
/// to its own on a block's edge shorter than the depth over the slack of Eq. (27): the penetration turns so
/// short an edge that its other corner fails the entrance-angle test. Where two faces overlap by so little
/// that they have one contact, the corner at the other end of the overlap may be deeper by the angle between
/// the faces.
class InheritedPenetrations {
  public:
    /// @param vertices per corner, m. @param contacts at the same time. @param search_radius m, see
    /// DetectionInput.
    InheritedPenetrations(const Topology& topology, CornerSpan<const Vec2> vertices,
                          ContactSpan<const Contact> contacts, double search_radius, const ThreadPool& pool);

    /// Largest depth of a corner in faces along a line, m; 0 if no contact accounts for one. A corner that
    /// slides from a face onto a neighbour's face is as deep in the second as it was in the first.
    /// @param normal unit, out of the faces' rock.
    double along(CornerIndex corner, const Vec2& normal) const;
    /// Largest depth of a corner in a block, through any face, m; 0 if no contact accounts for one. It is at
    /// least the compression of the contacts' springs, which augmentation makes larger than the penetration.
    double in_block(CornerIndex corner, BlockIndex block) const;
    /// How much deeper a corner may be in a block than that, m, as it is at the other end of a short overlap.
    double lean_in_block(CornerIndex corner, BlockIndex block) const;

  private:
    struct Entry {
        BlockIndex block;         ///< the block in whose face the corner is
        Vec2 normal;              ///< unit, of that face, out of its rock
        double depth = 0;         ///< m
        double spring_depth = 0;  ///< m, compression of the contact's spring
        double lean = 0;          ///< m, see lean_in_block()
    };
    struct Found;
    InheritedPenetrations(std::size_t corners, Found found);
    /// What some of the contacts account for.
    static Found find(const Topology& topology, CornerSpan<const Vec2> vertices,
                      std::span<const Contact> contacts, double search_radius);
    static Found find(const Topology& topology, CornerSpan<const Vec2> vertices,
                      std::span<const Contact> contacts, double search_radius, const ThreadPool& pool);
    const Entry& entry(std::uint32_t k) const { return entries_[k]; }

    std::vector<Entry> entries_;
    OwnerIndex<CornerIndex, std::uint32_t> by_corner_;
};

}  // namespace rockslope::dda
