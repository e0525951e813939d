#include "dda/linear/refined_factor.hpp"

#include <algorithm>

namespace dda {

namespace {

/// Of the right-hand side's norm, both scaled by the matrix' diagonal: what a factor in double precision
/// leaves of walls with springs of 100 E is as much.
constexpr double residual_share = 1e-11;
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
    solution_.clear();
}

bool RefinedFactor::factorize(const BlockMatrix& matrix, const Crew& crew, std::span<const char> changed) {
    matrix_ = &matrix;
    if (changed.empty()) solution_.clear();
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

bool RefinedFactor::solve(std::span<Vec6> x, const Crew& crew) {
    const double whole = scaled_square(x);
    const double enough = residual_share * residual_share * whole;
    if (enough == 0) return true;
    const bool goes_on = start(x, whole);
    double last = 0;
    for (int k = 0; k <= most_iterations; ++k) {
        if (scaled_square(residual_) <= enough) {
            std::copy(found_.begin(), found_.end(), x.begin());
            if (goes_on || solution_.empty()) solution_ = found_;
            return true;
        }
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
        if (!(curvature > 0)) break;  // rounding, or the matrix is indefinite
        const double step = energy / curvature;
        for (std::size_t i = 0; i < x.size(); ++i) {
            found_[i] += step * direction_[i];
            residual_[i] -= step * image_[i];
        }
    }
    solution_.clear();
    return false;
}

/// Begins with the solution before if it leaves less than nothing does: the right-hand sides of a step follow
/// each other, what a change of them does is another matter.
bool RefinedFactor::start(std::span<const Vec6> b, double whole) {
    image_.resize(b.size());
    residual_.assign(b.begin(), b.end());
    if (solution_.size() == b.size()) {
        matrix_->multiply(pattern_, solution_, image_);
        for (std::size_t i = 0; i < b.size(); ++i) residual_[i] -= image_[i];
        found_ = solution_;
        if (scaled_square(residual_) < whole) return true;
        residual_.assign(b.begin(), b.end());
    }
    found_.assign(b.size(), Vec6::Zero());
    return false;
}

}  // namespace dda
