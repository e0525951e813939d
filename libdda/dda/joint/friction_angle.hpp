#pragma once

#include <cmath>

namespace rockslope::dda {

/// An angle of friction with its coefficient, which the strength of each contact needs in each iteration.
class FrictionAngle {
  public:
    /// @param radians phi, in [0, pi/2).
    FrictionAngle(double radians = 0) : radians_(radians), coefficient_(std::tan(radians)) {}
    /// phi, rad.
    operator double() const { return radians_; }
    /// tan(phi).
    double coefficient() const { return coefficient_; }

  private:
    double radians_;
    double coefficient_;
};

}  // namespace rockslope::dda
