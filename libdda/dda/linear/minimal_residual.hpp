#pragma once

#include <Eigen/Core>
#include <vector>

namespace rockslope::dda {

/// GMRES for A x = r with a regular A [saadschultz1986]: the solution with the least residual in the space of
/// r, A r, A^2 r, ... The caller applies A to one direction after the other:
///
///     MinimalResidual solution(r);
///     while (solution.residual() > aim) solution.add(A * solution.direction());
class MinimalResidual {
  public:
    /// @param residual of x = 0: r.
    explicit MinimalResidual(const Eigen::VectorXd& residual);

    /// The norm of the residual that remains.
    double residual() const { return residual_; }
    /// The direction to which A is to be applied next, of unit length.
    const Eigen::VectorXd& direction() const { return directions_.back(); }
    /// @param image A times direction().
    void add(Eigen::VectorXd image);
    /// The solution's part along each direction to which A has been applied.
    const Eigen::VectorXd& coefficients() const { return coefficients_; }
    /// x; zero before the first direction.
    Eigen::VectorXd solution() const;

  private:
    std::vector<Eigen::VectorXd> directions_;  ///< orthonormal
    Eigen::MatrixXd hessenberg_;               ///< of A, with respect to the directions
    Eigen::VectorXd coefficients_;
    double first_residual_ = 0;
    double residual_ = 0;
};

}  // namespace rockslope::dda
