#include "dda/linear/refined_factor.hpp"

#include <algorithm>

namespace dda {

namespace {

/// Three to nine are normal. Where they do not suffice single precision is too little.
constexpr int most_iterations = 30;

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
}

bool RefinedFactor::factorize(const BlockMatrix& matrix, const Crew& crew, std::span<const char> changed) {
    matrix_ = &matrix;
    weight_.resize(matrix.diagonal.size());
    for (std::size_t i = 0; i < weight_.size(); ++i)
        weight_[i] = matrix.diagonal[i].diagonal().cwiseInverse();
    if (factor_.factorize(matrix, crew, changed)) return true;
    BlockMatrix held = matrix;
    for (Mat6& diagonal : held.diagonal) diagonal.diagonal() *= 1 + hold;
    return factor_.factorize(held, crew);
}

double RefinedFactor::scaled_square(std::span<const Vec6> v) const {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += v[i].cwiseAbs2().dot(weight_[i]);
    return sum;
}

RefinedFactor::Outcome RefinedFactor::refine(std::span<Vec6> x, std::span<const Vec6> b, double share,
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
