#pragma once

#include "dda/base/indices.hpp"

namespace rockslope::dda {

/// A part of an edge on which a load or boundary acts. It is a material line: it moves and stretches with
/// the rock.
struct FacePart {
    EdgeIndex edge;
    double from = 0;  ///< start of the part, fraction of the edge's length, in [0, 1)
    double to = 1;    ///< end of the part, above `from`
};

}  // namespace rockslope::dda
