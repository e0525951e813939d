#pragma once

#include "support/random_shapes.hpp"

namespace rockslope::scene {

/// Layers of random blocks, about 1 m by 1 m, on a slope of 35 degrees that ends on a level plane. Without
/// support at the foot they slide down and run out. Block 0 is the ground. Friction 8 degrees.
inline Scene collapsing_slope(int columns, int layers, unsigned seed) {
    Scene s;
    s.friction(8);
    const double dip = radians(35);
    const Vec2 up_dip(-std::cos(dip), std::sin(dip));
    const Vec2 outwards(std::sin(dip), std::cos(dip));
    const Vec2 foot(0, 0);
    const Vec2 top = foot + (columns + 5) * up_dip;
    const double plane = 10.0 * columns;
    s.block({{{top.x(), -5}, {plane, -5}, {plane, 0}, foot, top}}, dda::Motion::fixed);
    RandomSource random(seed);
    for (int layer = 0; layer < layers; ++layer) {
        // Joints across a layer lean by up to 10 degrees. The lowest layer begins 2 m above the foot.
        double low = 2;
        double low_above = 2 + .2 * random.between(-1, 1);
        for (int column = 0; column < columns; ++column) {
            const double high = low + random.between(.7, 1.3);
            const double high_above = high + .18 * random.between(-1, 1);
            const auto at = [&](double along, double across) -> Vec2 {
                return foot + along * up_dip + across * outwards;
            };
            s.block({{at(high, layer), at(low, layer), at(low_above, layer + 1), at(high_above, layer + 1)}});
            low = high;
            low_above = high_above;
        }
    }
    return s;
}

}  // namespace rockslope::scene
