#pragma once

#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::peer {

/// A block as GEOS sees it: its area, m2, and a point inside.
struct GeosBlock {
    double area = 0;
    Point inside;
};

/// The bounded faces that GEOS makes of outline and traces by union and polygonization in floating point,
/// those within the outline. Holes, regions and tunnels are not looked at.
/// @throws std::runtime_error with GEOS's own words.
std::vector<GeosBlock> geos_blocks(const Ring& outline, const std::vector<blockgen::Trace>& traces);

}  // namespace rockslope::peer
