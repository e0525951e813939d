#pragma once

#include "support/scene.hpp"

namespace rockslope::scene {

/// A fixed base, block 0, under a column of boxes of 1 m, blocks 1, 2, ...
inline Scene column(int boxes) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    for (int k = 0; k < boxes; ++k) s.box({0, static_cast<double>(k)}, 1, 1);
    return s;
}

}  // namespace rockslope::scene
