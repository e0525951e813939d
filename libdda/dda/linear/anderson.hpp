#pragma once

#include <Eigen/Core>
#include <deque>

namespace rockslope::dda {

/// Anderson acceleration of a fixed-point iteration x = g(x). The next iterate is the linear combination of
/// the last few g(x) that minimises the norm of the combined residual g(x) - x. For an affine g it is
/// equivalent to GMRES, and converges where plain iteration oscillates or grows. [Anderson 1965; Walker & Ni
/// 2011]
class AndersonMixing {
  public:
    /// @param memory number of earlier iterates combined; 0 or less is plain iteration.
    explicit AndersonMixing(int memory) : memory_(memory) {}

    /// The next iterate. @param image g(x).
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

  private:
    int memory_;
    Eigen::VectorXd last_residual_;
    Eigen::VectorXd last_image_;
    std::deque<Eigen::VectorXd> residual_changes_;
    std::deque<Eigen::VectorXd> image_changes_;
};

}  // namespace rockslope::dda
