#include "dda/linear/refined_factor.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace dda {

namespace {

/// Three to nine are normal. Where they do not suffice single precision is too little.
constexpr int most_iterations = 30;

/// Of the diagonal, by which it is raised where rounding in single precision takes a pivot below zero, as of
/// a splinter between stiff springs: the preconditioner need not be exact.
constexpr double hold = 4e-6;

double dot(std::span<const Vec6> a, std::span<const Vec6> b, const Crew& crew) {
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += a[i].dot(b[i]);
        return sum;
    };
    return crew.taken_together(a.size(), 0.0, of_portion, std::plus<>());
}

double scaled_square(const Vec6& v, const Vec6& weight) {
    return v.cwiseAbs2().dot(weight);
}

}  // namespace

void RefinedFactor::analyze(const BlockPattern& pattern, const SupernodeTree& tree) {
    pattern_ = pattern;
    factor_.analyze(pattern, tree);
}

bool RefinedFactor::factorize(const BlockMatrix& matrix, const Crew& crew, std::span<const char> changed) {
    matrix_ = &matrix;
    weight_.resize(matrix.diagonal.size());
    crew.for_ranges(weight_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) weight_[i] = matrix.diagonal[i].diagonal().cwiseInverse();
    });
    if (factor_.factorize(matrix, crew, changed)) return true;
    BlockMatrix held = matrix;
    for (Mat6& diagonal : held.diagonal) diagonal.diagonal() *= 1 + hold;
    return factor_.factorize(held, crew);
}

RefinedFactor::Outcome RefinedFactor::refine(std::span<Vec6> x, std::span<const Vec6> b, double share,
                                             const Crew& crew) {
    const Squares squares = start(x, b, crew);
    const double enough = share * share * squares.load;
    double left = squares.residual;
    double last = 0;
    for (int k = 0; k <= most_iterations; ++k) {
        if (left <= enough) return {true, k};
        refined_ = residual_;
        factor_.solve(refined_, crew);
        const double energy = dot(residual_, refined_, crew);
        if (k == 0) {
            std::swap(direction_, refined_);
        } else {
            crew.for_ranges(x.size(), [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    direction_[i] = refined_[i] + (energy / last) * direction_[i];
            });
        }
        last = energy;
        matrix_->multiply(pattern_, direction_, image_, crew);
        const double curvature = dot(direction_, image_, crew);
        if (!(curvature > 0)) return {false, k + 1};  // rounding, or the matrix is indefinite
        const double step = energy / curvature;
        const auto go = [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i) {
                x[i] += step * direction_[i];
                residual_[i] -= step * image_[i];
                sum += scaled_square(residual_[i], weight_[i]);
            }
            return sum;
        };
        left = crew.taken_together(x.size(), 0.0, go, std::plus<>());
    }
    return {false, most_iterations + 1};
}

RefinedFactor::Squares RefinedFactor::start(std::span<Vec6> x, std::span<const Vec6> b, const Crew& crew) {
    image_.resize(b.size());
    residual_.resize(b.size());
    matrix_->multiply(pattern_, x, image_, crew);
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        Squares squares;
        for (std::size_t i = begin; i < end; ++i) {
            residual_[i] = b[i] - image_[i];
            squares.residual += scaled_square(residual_[i], weight_[i]);
            squares.load += scaled_square(b[i], weight_[i]);
        }
        return squares;
    };
    const auto add = [](const Squares& sum, const Squares& more) {
        return Squares{sum.residual + more.residual, sum.load + more.load};
    };
    Squares squares = crew.taken_together(b.size(), Squares(), of_portion, add);
    if (squares.residual <= squares.load) return squares;
    std::fill(x.begin(), x.end(), Vec6::Zero());
    residual_.assign(b.begin(), b.end());
    squares.residual = squares.load;
    return squares;
}

}  // namespace dda
