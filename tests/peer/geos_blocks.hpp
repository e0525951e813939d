#pragma once

#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::peer {

/// A block found by GEOS: its area, m2, and a point inside.
struct GeosBlock {
    double area = 0;
    Point inside;
};

/// The bounded faces inside the outline that GEOS finds by union and polygonization of outline and traces in
/// floating point. Holes, regions and tunnels are ignored. @throws std::runtime_error with GEOS's message.
std::vector<GeosBlock> geos_blocks(const Ring& outline, const std::vector<blockgen::Trace>& traces);

}  // namespace rockslope::peer
