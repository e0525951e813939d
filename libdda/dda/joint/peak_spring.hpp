#pragma once

#include "dda/joint/barton.hpp"

namespace dda {

/// The shear spring that takes a rough joint to its peak strength at its peak displacement, Eq. (52). It is
/// that of the largest force the joint has borne, so that it does not depend on how the load came, and it
/// belongs to the joint: where faces overlap less, all of the spring is in what is left.
struct PeakSpring {
    double stiffness = 0;  ///< N/m per metre, of the whole joint; 0: it has borne nothing yet
    double length = 0;     ///< m, of the joint when it was pressed last

    /// The spring after the joint has borne a force. A joint without a length, a bare corner, has none.
    /// @param normal_force N per metre, positive; @param length m, of the whole joint; @param
    /// stressed_length m, that the stress is computed with; @param peak_displacement m, positive.
    PeakSpring pressed(const BartonStrength& barton, double normal_force, double length,
                       double stressed_length, double peak_displacement) const;
    /// N/m per metre, of the part of the joint that has this length, m.
    double of_part(double part) const;
    friend bool operator==(const PeakSpring&, const PeakSpring&) = default;
};

}  // namespace dda
