#pragma once

namespace rockslope::dda {

/// A part of an edge that loads or boundaries act on. It is marked on the rock: it moves and stretches with
/// it.
struct FacePart {
    int edge = 0;     ///< first corner of the edge
    double from = 0;  ///< where the part begins, as a share of the edge, in [0, 1)
    double to = 1;    ///< where it ends, above `from`
};

}  // namespace rockslope::dda
