#pragma once

#include <cstdint>

#include "dda/joint/barton.hpp"

namespace rockslope::dda {

/// The shear spring that takes a rough joint to its peak strength at its peak displacement, Eq. (58). It is
/// that of the largest force the joint has borne at rest, in static stages, and stays so when it is shaken;
/// one that has never been at rest has that of the largest force so far. It belongs to the joint: where faces
/// overlap less, all of the spring is in what is left.
struct PeakSpring {
    double stiffness = 0;            ///< N/m per metre, of the whole joint; 0: it has borne nothing yet
    double length = 0;               ///< m, of the joint when it was loaded last
    std::int64_t found_at_rest = 0;  ///< whether it was found at rest; an integer, for its bytes are written

    /// The force that a joint bears, and where.
    struct NormalLoad {
        double normal_force = 0;     ///< N per metre
        double length = 0;           ///< m, of the whole joint
        double stressed_length = 0;  ///< m, that the stress is computed with
        bool at_rest = false;
    };
    /// The spring after the joint has borne a force. A joint without a length, a bare corner, has none.
    /// @param peak_displacement m; 0: none.
    PeakSpring loaded(const NormalLoad& load, const BartonStrength& barton, double peak_displacement) const;
    /// N/m per metre, of the part of the joint that has this length, m.
    double stiffness_of_part(double part) const;
    friend bool operator==(const PeakSpring&, const PeakSpring&) = default;
};

}  // namespace rockslope::dda
