#pragma once

#include <Eigen/Core>
#include <deque>

namespace rockslope::dda {

/// Anderson's acceleration of a fixed-point iteration x = g(x): the next iterate combines the last few so
/// that their combined residual g(x) - x is least. For an affine g it is the generalised minimal residual
/// method, and converges where plain iteration oscillates or grows. [Anderson 1965; Walker & Ni 2011]
class AndersonMixing {
  public:
    /// @param memory how many earlier steps it combines; with none (0 or less) it is plain iteration.
    explicit AndersonMixing(int memory) : memory_(memory) {}

    /// The next iterate from x and g(x).
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

  private:
    int memory_;
    Eigen::VectorXd last_residual_;
    Eigen::VectorXd last_image_;
    std::deque<Eigen::VectorXd> residual_changes_;
    std::deque<Eigen::VectorXd> image_changes_;
};

}  // namespace rockslope::dda
