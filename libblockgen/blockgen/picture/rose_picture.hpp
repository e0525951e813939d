#pragma once

#include <span>
#include <string>

#include "common/drawing/canvas.hpp"

namespace rockslope::blockgen {

/// The directions of a set of joints: their length by classes of equal width from -90 to 90 degrees, m.
struct RoseSet {
    std::string name;
    std::span<const double> length_by_direction;
};

/// Draws a rose diagram of the directions of joints. A petal's area is the length in its class, and the sets
/// share it; each direction appears on both sides, for joints have none. Circles show shares of the length.
Canvas draw_rose(std::span<const RoseSet> sets, const PageStyle& style = {});

}  // namespace rockslope::blockgen
