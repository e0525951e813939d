#pragma once

#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// A rigid block on a plane through its ground, without cohesion.
struct SlidingPlane {
    double dip = 0;       ///< rad, of the plane, from 0, less than pi/2; it falls towards +x
    double friction = 0;  ///< rad, angle of friction, from 0, less than pi/2
};

/// What a plane bears against sliding, per mass of the block.
struct PlaneStrength {
    double friction = 0;  ///< tangent of the angle of friction
    double adhesion = 0;  ///< m/s2: cohesion times the length of the plane over the block's mass
};

/// A rigid block that slides on a plane, one way or the other, with the residual strength from its first
/// slip on.
class RigidSlider {
  public:
    RigidSlider(const PlaneStrength& peak, const PlaneStrength& residual)
        : strength_(peak), residual_(residual) {}

    /// Over `dt` seconds of constant accelerations, m/s2: `drive` downhill and `pressure` into the plane;
    /// without pressure there is no friction. Friction stops the block, and does not turn it round.
    void advance(double drive, double pressure, double dt);
    double slip() const { return slip_; }  ///< m, downhill positive

  private:
    PlaneStrength strength_;
    PlaneStrength residual_;
    double speed_ = 0;  ///< m/s
    double slip_ = 0;
};

/// s: pieces no longer than this are short enough for accelerations of earthquakes.
inline constexpr double max_sliding_substep = 2.5e-4;

/// The horizontal acceleration of the ground, over g, at which a block begins to slide downhill, towards +x
/// relative to the ground: the ground moves towards -x. tan(friction - dip), negative when it slides by
/// itself (Newmark 1965).
double yield_coefficient(const SlidingPlane& plane);

/// Slip of the block over the ground at the record's instants, m, positive downhill; it may slide uphill,
/// too. The block's equation along the plane is
///   s'' = g sin(dip) - a cos(dip) - sign(s') mu N,  N = max(0, g cos(dip) + a sin(dip)),
/// with a the ground's horizontal acceleration towards +x; it sticks while the drive is within friction.
/// Integrated in pieces of 0.25 ms or less with the acceleration in their middle.
/// @throws std::invalid_argument for angles out of range.
std::vector<double> newmark_slip(const Accelerogram& record, const SlidingPlane& plane,
                                 double gravity = 9.81);

}  // namespace rockslope::record
