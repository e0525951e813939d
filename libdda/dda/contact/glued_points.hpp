#pragma once

#include <utility>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Points of the first configuration round which blocks are glued together by bonds that cannot break: the
/// law has unlimited tensile strength. Two blocks that meet only at such a point, as opposite triangles of a
/// mesh do, are one body there. They get no contact, because its one-sided spring would close and open with
/// every strain of the body, and its entrance lines are those of two corners that point at each other.
class GluedPoints {
  public:
    /// @param contacts of the first step or later; bonds stay as they are until a block is removed.
    GluedPoints(const Model& model, ContactSpan<const Contact> contacts);

    /// Whether no block is glued.
    bool empty() const { return bonds_.empty(); }
    /// Whether the corner and the edge meet at a glued point, and their blocks have no bond with each other
    /// there.
    bool joins(const CornerEdge& pair) const;
    /// Removes the pairs that glued points join.
    void remove_from(std::vector<CornerEdge>& candidates) const;

  private:
    struct Bond {
        CornerIndex point;  ///< the lowest corner at the glued point
        BlockIndex first, second;
        friend auto operator<=>(const Bond&, const Bond&) = default;
    };
    const Model& model_;
    PerCorner<CornerIndex> point_;                            ///< of each corner; none where nothing is glued
    std::vector<Bond> bonds_;                                 ///< sorted; each with first < second
    std::vector<std::pair<CornerIndex, BlockIndex>> blocks_;  ///< at each glued point, sorted
};

}  // namespace rockslope::dda
