#pragma once

#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace dda {

/// Pairs of faces that lie on each other, as their contacts: between the same two blocks, of one joint
/// material and on one line. What rough faces have been through belongs to both of their ends. Only contacts
/// whose law says so are here; one without a shared length stands alone.
class JointFaces {
  public:
    JointFaces() = default;
    JointFaces(const Model& model, std::span<const Contact> contacts);

    std::size_t count() const { return first_.size() - 1; }
    /// How many contacts are between pairs of faces before this one; between all, for the number of pairs.
    std::size_t members_before(std::size_t faces) const { return first_[faces]; }
    /// Indices of the contacts between one pair of faces, ascending.
    std::span<const int> contacts_of(std::size_t faces) const {
        return {members_.data() + first_[faces], members_.data() + first_[faces + 1]};
    }

  private:
    std::vector<int> members_;
    std::vector<std::size_t> first_ = {0};
};

}  // namespace dda
