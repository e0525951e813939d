#pragma once

namespace rockslope::dda {

/// A part of a shear path on which a friction or dilation angle is linear in the displacement.
struct LinearAngle {
    double length = 0;  ///< m
    double first = 0;   ///< rad
    double last = 0;    ///< rad

    /// The angle at a distance from the start, rad. @param distance m, from 0 to the length.
    double angle_at(double along) const {
        return length > 0 ? first + (last - first) * (along / length) : last;
    }
};

/// Mean of tan(angle) over a piece with angles within 90 deg: exact, without cancellation where the two
/// angles are close, Eq. (61).
double mean_tangent(double first, double last);

/// Integral of the dilation rate min(max(tan(angle), 0), climb x) over a piece that begins at the distance x
/// = `start` from the joint's origin, m: the dilation of a joint that has not slipped, Eq. (79). @param climb
/// 1/m.
double dilation_before_slip(const LinearAngle& piece, double start, double climb);

/// The leading part of a piece with the angle limited to [lowest, highest]. It ends where the free angle
/// crosses a limit, so the limited angle is linear on it.
LinearAngle clamp_leading_part(const LinearAngle& piece, double lowest, double highest);

/// Minimum over a piece of N tan(angle) + k (L - s), with s along the piece and L >= its length: the largest
/// shear force at L of a joint with the spring k whose force is at most N tan(angle) on the piece, Eq. (62).
/// @param remaining m, L at the start of the piece.
double end_force_bound(const LinearAngle& piece, double normal_force, double stiffness, double remaining);

}  // namespace rockslope::dda
