#pragma once

#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Pairs of faces that lie on each other, as their contacts: between the same two blocks, of one joint
/// material and on one line. What rough faces have been through belongs to both of their ends. Only contacts
/// whose law says so are here; one without a shared length stands alone.
class JointSegments {
  public:
    JointSegments() = default;
    JointSegments(const Model& model, std::span<const Contact> contacts);

    std::size_t count() const { return offsets_.size() - 1; }
    /// How many contacts are between pairs of faces before this one; between all, for the number of pairs.
    std::size_t first_member(std::size_t segment) const { return offsets_[segment]; }
    /// Indices of the contacts between one pair of faces, ascending.
    std::span<const int> contacts_of(std::size_t segment) const {
        return {members_.data() + offsets_[segment], members_.data() + offsets_[segment + 1]};
    }

  private:
    std::vector<int> members_;
    std::vector<std::size_t> offsets_ = {0};
};

}  // namespace rockslope::dda
