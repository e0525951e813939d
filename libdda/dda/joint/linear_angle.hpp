#pragma once

namespace rockslope::dda {

/// A part of a shear path along which a friction or dilation angle goes evenly from one value to another.
struct LinearAngle {
    double length = 0;  ///< m
    double first = 0;   ///< rad
    double last = 0;    ///< rad

    double angle_at(double along) const {
        return length > 0 ? first + (last - first) * (along / length) : last;
    }
};

/// Mean of tan(angle) over a piece, whose angles are within 90 deg: exact, and without cancellation where the
/// two ends are close.
double mean_tangent(double first, double last);

/// The beginning of a piece, up to where its angle reaches one of the limits or leaves it, held within them:
/// an angle that is cut off at a limit is even again on each such part.
LinearAngle clamp_leading_part(const LinearAngle& piece, double lowest, double highest);

/// The smallest value on a piece of N tan(angle) + k (L - s), with s along the piece and L >= its length. A
/// shear force that climbs with the spring k and is cut off at N tan(angle) all along the piece can be no
/// larger than this when the joint arrives at L, Eq. (62).
/// @param remaining m, L at the start of the piece.
double end_force_bound(const LinearAngle& piece, double normal_force, double stiffness, double remaining);

}  // namespace rockslope::dda
