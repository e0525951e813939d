#include "dda/linear/minimal_residual.hpp"

#include <Eigen/QR>
#include <utility>

namespace rockslope::dda {

MinimalResidual::MinimalResidual(const Eigen::VectorXd& residual)
    : first_residual_(residual.norm()), residual_(first_residual_) {
    directions_.push_back(first_residual_ > 0 ? Eigen::VectorXd(residual / first_residual_) : residual);
}

void MinimalResidual::add(Eigen::VectorXd image) {
    const auto count = static_cast<Eigen::Index>(directions_.size());
    hessenberg_.conservativeResize(count + 1, count);
    hessenberg_.row(count).setZero();
    for (Eigen::Index k = 0; k < count; ++k) {
        hessenberg_(k, count - 1) = image.dot(directions_[k]);
        image -= hessenberg_(k, count - 1) * directions_[k];
    }
    const double length = image.norm();
    hessenberg_(count, count - 1) = length;
    const Eigen::VectorXd aim = first_residual_ * Eigen::VectorXd::Unit(count + 1, 0);
    coefficients_ = hessenberg_.householderQr().solve(aim);
    residual_ = (hessenberg_ * coefficients_ - aim).norm();
    if (length > 0) image /= length;
    directions_.push_back(std::move(image));
}

Eigen::VectorXd MinimalResidual::solution() const {
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(directions_.front().size());
    for (Eigen::Index k = 0; k < coefficients_.size(); ++k) solution += coefficients_[k] * directions_[k];
    return solution;
}

}  // namespace rockslope::dda
