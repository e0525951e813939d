#pragma once

#include <vector>

#include "blockgen/input/distribution.hpp"

namespace rockslope::blockgen {

/// The upward unit normal of a joint plane in the axes of the section: x along the section, up, and out of
/// the section, which is to the left of x seen from above.
struct Pole {
    double x = 0, up = 1, out = 0;
};

/// @param dip of the plane below the horizontal, rad. @param dip_direction of the plane and @param azimuth of
/// the section's x axis, rad, clockwise from north.
Pole pole_of(double dip, double dip_direction, double azimuth);

/// Orientation of the joints of a set: angles in the section, or planes in space cut by the section.
struct Orientation {
    Distribution angle;       ///< rad; used when there are no poles
    std::vector<Pole> poles;  ///< one: the mean pole; several: measured poles, one of which each joint takes
    double fisher_k = 0;      ///< Fisher concentration of the poles about the mean pole; 0: no scatter
    /// Whether joints take a pole as often as the section meets planes of it, rather than as often as there
    /// are such planes: with the weight section_chance() (Terzaghi 1965).
    bool weighted_by_section = false;

    /// Whether the direction of a joint may differ from the mean direction.
    bool has_scatter() const;
    /// The angle of the mean direction in the section, rad.
    double mean_angle() const;
    /// Tangent of the angle to the mean direction that only one joint in ten thousand exceeds; at most
    /// tan 89 deg.
    double max_deviation_tangent() const;
    /// Spacing in the section over true spacing for the mean plane: 1 / sqrt(1 - (n.t)^2) with the plane's
    /// normal n and the section's normal t. Infinite for a plane parallel to the section.
    double spacing_factor() const;
    /// The angle of one joint in the section, rad, for two uniform numbers in (0, 1). Poles follow the Fisher
    /// distribution (1953): the angle a to the mean pole has the quantile
    /// cos a = 1 + ln(1 - u (1 - exp(-2 K))) / K.
    double draw(double u, double v) const;
    /// The pole of one plane, for two uniform numbers in (0, 1) as above; there must be poles. Not weighted.
    Pole draw_pole(double u, double v) const;
};

/// Dip below the horizontal and dip direction clockwise from north, rad.
struct PlaneAngles {
    double dip = 0, dip_direction = 0;
};

/// The plane of a pole: the inverse of pole_of(). A pole of either sign gives the same plane.
/// @return a dip in [0, pi/2] and a dip direction in [0, 2 pi).
PlaneAngles plane_of(const Pole& pole, double azimuth);

/// The angle in the section of a plane's trace, rad.
double trace_angle(const Pole& pole);

/// Chance that a section meets a plane of this pole, relative to one across it: sqrt(1 - (n.t)^2) with the
/// plane's normal n and the section's normal t.
double section_chance(const Pole& pole);

}  // namespace rockslope::blockgen
