#pragma once

#include <cstdint>

#include "dda/joint/barton.hpp"

namespace rockslope::dda {

/// Shear spring with which a rough joint reaches its peak strength at its peak displacement, Eq. (58). The
/// normal force is the largest one at rest, in static stages, and dynamic stages do not change it; a joint
/// that has never been at rest uses the largest force so far. The spring is that of the whole joint: where
/// the faces overlap less than before, the remaining part has the whole spring.
struct PeakSpring {
    double stiffness = 0;            ///< N/m per metre, of the whole joint; 0: not loaded yet
    double length = 0;               ///< m, of the joint at its last loading
    double normal_stress = 0;        ///< Pa, at which the stiffness was found; also sets the dilation angle
    std::int64_t found_at_rest = 0;  ///< 1 if found at rest; an integer without padding, for checkpoints

    /// Normal force on a joint.
    struct NormalLoad {
        double normal_force = 0;     ///< N per metre
        double length = 0;           ///< m, of the whole joint
        double stressed_length = 0;  ///< m, length that the stress is computed with
        bool at_rest = false;
    };
    /// The spring after a loading. A joint without a length, a bare vertex, has none. @param
    /// peak_displacement m; 0: no spring.
    PeakSpring loaded(const NormalLoad& load, const BartonStrength& barton, double peak_displacement) const;
    /// Stiffness of a part of the joint with this length (m), N/m per metre.
    double stiffness_of_part(double part) const;
    /// The normal force at which the spring was found, N per metre. @param stressed_length m.
    double normal_force(double stressed_length) const { return normal_stress * stressed_length; }
    friend bool operator==(const PeakSpring&, const PeakSpring&) = default;
};

}  // namespace rockslope::dda
