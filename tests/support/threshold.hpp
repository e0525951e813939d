#pragma once

#include <functional>

namespace rockslope::scene {

/// Bisects for the value at which an outcome changes. `holds` must be false at `fails` and true at `stands`;
/// either may be larger. @return the middle of the bracket after `halvings` bisections.
inline double threshold(double fails, double stands, int halvings, const std::function<bool(double)>& holds) {
    for (int k = 0; k < halvings; ++k) {
        const double middle = (fails + stands) / 2;
        (holds(middle) ? stands : fails) = middle;
    }
    return (fails + stands) / 2;
}

}  // namespace rockslope::scene
