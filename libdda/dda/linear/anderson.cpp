#include "dda/linear/anderson.hpp"

#include <Eigen/QR>

namespace rockslope::dda {

Eigen::VectorXd AndersonMixing::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image) {
    const Eigen::VectorXd residual = image - x;
    Eigen::VectorXd mixed = image;
    if (memory_ > 0 && last_residual_.size() == residual.size() && residual.size() > 0) {
        residual_changes_.push_back(residual - last_residual_);
        image_changes_.push_back(image - last_image_);
        if (static_cast<int>(residual_changes_.size()) > memory_) {
            residual_changes_.pop_front();
            image_changes_.pop_front();
        }
        Eigen::MatrixXd changes(residual.size(), static_cast<Eigen::Index>(residual_changes_.size()));
        for (Eigen::Index k = 0; k < changes.cols(); ++k) changes.col(k) = residual_changes_[k];
        const Eigen::VectorXd weights = changes.colPivHouseholderQr().solve(residual);
        for (Eigen::Index k = 0; k < changes.cols(); ++k) mixed -= weights[k] * image_changes_[k];
    }
    last_residual_ = residual;
    last_image_ = image;
    return mixed;
}

}  // namespace rockslope::dda
