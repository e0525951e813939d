#pragma once

#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The joint segments of a list of contacts. A joint segment is two faces that lie on each other: its
/// contacts are between the same two blocks, have one joint material and lie on one line. Only contacts whose
/// law has the history scope `joint_segment` are members. A contact without a length is a segment by itself.
class JointSegments {
  public:
    JointSegments() = default;
    JointSegments(const Model& model, ContactSpan<const Contact> contacts);

    /// Number of joint segments.
    std::size_t count() const { return offsets_.size() - 1; }
    /// Number of members of all segments before this one; of all segments, for `count()`.
    std::size_t first_member(std::size_t segment) const { return offsets_[segment]; }
    /// Indices of the contacts of a segment, ascending.
    std::span<const ContactIndex> contacts_of(std::size_t segment) const {
        return {members_.data() + offsets_[segment], members_.data() + offsets_[segment + 1]};
    }

  private:
    std::vector<ContactIndex> members_;
    std::vector<std::size_t> offsets_ = {0};
};

}  // namespace rockslope::dda
