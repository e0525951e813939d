#pragma once

#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// A cohesionless plane on which a rigid block slides.
struct SlidingPlane {
    double dip = 0;       ///< rad, in [0, pi/2); the plane dips towards +x
    double friction = 0;  ///< rad, friction angle, in [0, pi/2)
};

/// Shear strength of a plane per mass of the block: friction * normal acceleration + adhesion.
struct PlaneStrength {
    double friction = 0;  ///< tangent of the friction angle
    double adhesion = 0;  ///< m/s2, cohesion times the length of the plane over the mass of the block
};

/// A rigid block that slides on a plane in either direction. From its first slip on it has the residual
/// strength.
class RigidSlider {
  public:
    RigidSlider(const PlaneStrength& peak, const PlaneStrength& residual)
        : strength_(peak), residual_(residual) {}

    /// Advances by `dt` seconds under constant accelerations, m/s2: `drive` downhill, `pressure` into the
    /// plane. A negative pressure gives no friction. Friction can stop the block but not reverse it.
    void advance(double drive, double pressure, double dt);
    double slip() const { return slip_; }  ///< m, downhill positive

  private:
    PlaneStrength strength_;
    PlaneStrength residual_;
    double speed_ = 0;  ///< m/s
    double slip_ = 0;
};

/// Longest substep for earthquake accelerations, s.
inline constexpr double max_sliding_substep = 2.5e-4;

/// Yield coefficient tan(friction - dip): the horizontal ground acceleration over g, towards -x, at which the
/// block begins to slide downhill (Newmark 1965). Negative if it slides under its own weight.
double yield_coefficient(const SlidingPlane& plane);

/// Slip of the block relative to the ground at the samples of the record, m, positive downhill. The block may
/// also slide uphill. Its equation of motion along the plane is
///   s'' = g sin(dip) - a cos(dip) - sign(s') mu N,  N = max(0, g cos(dip) + a sin(dip)),
/// with a the horizontal ground acceleration towards +x. The block sticks while the drive is below friction.
/// Integrated in substeps of 0.25 ms or less, with the acceleration at their midpoints.
/// @throws std::invalid_argument for angles out of range.
std::vector<double> newmark_slip(const Accelerogram& record, const SlidingPlane& plane,
                                 double gravity = 9.81);

}  // namespace rockslope::record
