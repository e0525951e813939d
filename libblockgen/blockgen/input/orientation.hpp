#pragma once

#include <vector>

#include "blockgen/input/distribution.hpp"

namespace rockslope::blockgen {

/// A joint plane's upward unit normal in the axes of the section: x along it, y up, z out of it to the
/// reader's left hand of x seen from above.
struct Pole {
    double x = 0, up = 1, out = 0;
};

/// @param dip, dip_direction of the plane and azimuth of the section's x axis, rad; directions clockwise from
/// north, dip below the horizontal.
Pole pole_of(double dip, double dip_direction, double azimuth);

/// How the joints of a set lie: angles in the section, or planes in space that the section cuts.
struct Orientation {
    Distribution angle;       ///< rad; used when there is no pole
    std::vector<Pole> poles;  ///< one: the mean; several: measured ones, each joint takes one of them
    double fisher_k = 0;      ///< scatter of the joints' poles about the mean one; 0: none

    /// Whether joints may lie otherwise than the mean.
    bool has_scatter() const;
    /// The angle of the mean joint, rad.
    double mean_angle() const;
    /// The largest tangent between a joint and the mean one, but for one joint in ten thousand; never beyond
    /// that of 89 degrees.
    double max_deviation_tangent() const;
    /// Spacing in the section over true spacing, of the mean plane: 1 / sqrt(1 - (n.t)^2) with the plane's
    /// normal n and the section's normal t. Infinite for a plane parallel to the section.
    double spacing_factor() const;
    /// The angle of one joint for two numbers in (0, 1), rad. Fisher's law on the sphere (1953): the angle
    /// from the mean has the quantile cos = 1 + ln(1 - u (1 - exp(-2 K))) / K.
    double draw(double u, double v) const;
};

}  // namespace rockslope::blockgen
