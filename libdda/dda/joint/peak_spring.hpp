#pragma once

#include <cstdint>

#include "dda/joint/barton.hpp"

namespace rockslope::dda {

/// Shear spring with which a rough joint reaches its peak strength at its peak displacement, Eq. (58). The
/// normal force is the largest one at rest, in static stages, and dynamic stages do not change it; a joint
/// that has never been at rest uses the largest force so far. A joint that opens leaves its rest: where it
/// lands under a larger force its spring becomes that of this force, for a landing on the spring of rest
/// would be too soft. The reference force and stress stay those of the rest. The spring is that of the whole
/// joint: where the faces overlap less than before, the remaining part has the whole spring.
struct PeakSpring {
    /// When the spring was found; integers without padding, for checkpoints.
    enum Found : std::int64_t { never_at_rest, at_rest, after_a_rest };

    double stiffness = 0;      ///< N/m per metre, of the whole joint; 0: not loaded yet
    double length = 0;         ///< m, of the joint at its last loading
    double normal_force = 0;   ///< N per metre, of the rest at which the stiffness was found
    double normal_stress = 0;  ///< Pa, then; it sets the dilation angle
    Found found = never_at_rest;

    /// Normal force on a joint.
    struct NormalLoad {
        double normal_force = 0;     ///< N per metre
        double length = 0;           ///< m, of the whole joint
        double stressed_length = 0;  ///< m, length that the stress is computed with
        bool at_rest = false;
    };
    /// The spring after a loading. A joint without a length, a bare vertex, has none. @param
    /// peak_displacement m; 0: no spring, only the normal stress.
    PeakSpring loaded(const NormalLoad& load, const BartonStrength& barton, double peak_displacement) const;
    /// The joint has opened: its next loading in a dynamic stage is a landing.
    void leave_rest() {
        if (found == at_rest) found = after_a_rest;
    }
    /// Stiffness of a part of the joint with this length (m), N/m per metre.
    double stiffness_of_part(double part) const;
    friend bool operator==(const PeakSpring&, const PeakSpring&) = default;
};

}  // namespace rockslope::dda
