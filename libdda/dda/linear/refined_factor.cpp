#include "dda/linear/refined_factor.hpp"

#include <algorithm>

namespace dda {

namespace {

/// Three to nine are normal. Where they do not suffice single precision is too little.
constexpr int most_iterations = 30;

/// Of the diagonal, by which a row may change before the factor is made of it anew. At ten times that a wall
/// that stands takes five substitutions a step for four.
constexpr float most_drift = 1e-4F;
/// Substitutions of one solution by which a factor has drifted too far as a whole.
constexpr int slow = 10;

/// Of the diagonal, by which it is raised where rounding in single precision takes a pivot below zero, as of
/// a splinter between stiff springs: the preconditioner need not be exact.
constexpr double hold = 4e-6;

double dot(std::span<const Vec6> a, std::span<const Vec6> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

}  // namespace

void RefinedFactor::analyze(const BlockPattern& pattern, const SupernodeTree& tree) {
    pattern_ = pattern;
    factor_.analyze(pattern, tree);
    drift_.clear();
}

std::span<const float> RefinedFactor::outdated(std::span<const float> changed) {
    const bool all = changed.empty() || drift_.size() != changed.size();
    if (all) drift_.assign(changed.size(), 0);
    outdated_.assign(drift_.size(), 0);
    if (all) return {};
    for (std::size_t row = 0; row < drift_.size(); ++row) {
        drift_[row] += changed[row];
        if (drift_[row] <= most_drift) continue;
        outdated_[row] = drift_[row];
        drift_[row] = 0;
    }
    return outdated_;
}

bool RefinedFactor::factorize(const BlockMatrix& matrix, const Crew& crew, std::span<const float> changed) {
    matrix_ = &matrix;
    weight_.resize(matrix.diagonal.size());
    for (std::size_t i = 0; i < weight_.size(); ++i)
        weight_[i] = matrix.diagonal[i].diagonal().cwiseInverse();
    return factor_.factorize(matrix, crew, outdated(changed)) || renew(crew);
}

/// Of the whole present matrix, with its diagonal raised if need be.
bool RefinedFactor::renew(const Crew& crew) {
    std::fill(drift_.begin(), drift_.end(), 0.0F);
    if (factor_.factorize(*matrix_, crew)) return true;
    BlockMatrix held = *matrix_;
    for (Mat6& diagonal : held.diagonal) diagonal.diagonal() *= 1 + hold;
    return factor_.factorize(held, crew);
}

bool RefinedFactor::has_drifted() const {
    return std::any_of(drift_.begin(), drift_.end(), [](float drift) { return drift > 0; });
}

double RefinedFactor::scaled_square(std::span<const Vec6> v) const {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += v[i].cwiseAbs2().dot(weight_[i]);
    return sum;
}

RefinedFactor::Outcome RefinedFactor::refine(std::span<Vec6> x, std::span<const Vec6> b, double share,
                                             const Crew& crew) {
    const Outcome first = iterate(x, b, share, crew);
    if ((first.converged && first.substitutions < slow) || !has_drifted()) return first;
    if (!renew(crew)) return {false, first.substitutions};
    const Outcome second = iterate(x, b, share, crew);
    return {second.converged, first.substitutions + second.substitutions};
}

RefinedFactor::Outcome RefinedFactor::iterate(std::span<Vec6> x, std::span<const Vec6> b, double share,
                                              const Crew& crew) {
    const double whole = scaled_square(b);
    const double enough = share * share * whole;
    start(x, b, whole);
    double last = 0;
    for (int k = 0; k <= most_iterations; ++k) {
        if (scaled_square(residual_) <= enough) return {true, k};
        refined_ = residual_;
        factor_.solve(refined_, crew);
        const double energy = dot(residual_, refined_);
        if (k == 0)
            direction_ = refined_;
        else
            for (std::size_t i = 0; i < x.size(); ++i)
                direction_[i] = refined_[i] + (energy / last) * direction_[i];
        last = energy;
        matrix_->multiply(pattern_, direction_, image_);
        const double curvature = dot(direction_, image_);
        if (!(curvature > 0)) return {false, k + 1};  // rounding, or the matrix is indefinite
        const double step = energy / curvature;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += step * direction_[i];
            residual_[i] -= step * image_[i];
        }
    }
    return {false, most_iterations + 1};
}

void RefinedFactor::start(std::span<Vec6> x, std::span<const Vec6> b, double whole) {
    image_.resize(b.size());
    matrix_->multiply(pattern_, x, image_);
    residual_.resize(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) residual_[i] = b[i] - image_[i];
    if (scaled_square(residual_) <= whole) return;
    std::fill(x.begin(), x.end(), Vec6::Zero());
    residual_.assign(b.begin(), b.end());
}

}  // namespace dda
