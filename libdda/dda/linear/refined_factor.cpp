#include "dda/linear/refined_factor.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace rockslope::dda {

namespace {

/// Normally three to nine iterations converge. When these do not, single precision is not sufficient.
constexpr int max_iterations = 30;

/// Relative diagonal shift applied when rounding in single precision turns a pivot negative, as it does for a
/// splinter between stiff springs. The preconditioner need not be exact.
constexpr double diagonal_shift = 4e-6;

double dot(std::span<const Vec6> a, std::span<const Vec6> b, const ThreadPool& pool) {
    const auto chunk_value = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += a[i].dot(b[i]);
        return sum;
    };
    return pool.parallel_reduce(a.size(), 0.0, chunk_value, std::plus<>());
}

double weighted_square(const Vec6& v, const Vec6& weight) {
    return v.cwiseAbs2().dot(weight);
}

}  // namespace

void RefinedFactor::analyze(const BlockPattern& pattern, const SupernodeTree& tree) {
    pattern_ = pattern;
    factor_.analyze(pattern, tree);
}

bool RefinedFactor::factorize(const BlockMatrix& matrix, const ThreadPool& pool,
                              std::span<const char> changed) {
    matrix_ = &matrix;
    weight_.resize(matrix.diagonal.size());
    pool.parallel_for(weight_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) weight_[i] = matrix.diagonal[i].diagonal().cwiseInverse();
    });
    if (factor_.factorize(matrix, pool, changed)) return true;
    BlockMatrix shifted = matrix;
    for (Mat6& diagonal : shifted.diagonal) diagonal.diagonal() *= 1 + diagonal_shift;
    return factor_.factorize(shifted, pool);
}

RefinedFactor::Outcome RefinedFactor::refine(std::span<Vec6> x, std::span<const Vec6> b, double tolerance,
                                             const ThreadPool& pool) {
    const SquaredNorms squared_norms = reset_residual(x, b, pool);
    const double target = tolerance * tolerance * squared_norms.load;
    double residual_square = squared_norms.residual;
    double last_energy = 0;
    for (int k = 0; k <= max_iterations; ++k) {
        if (residual_square <= target) return {true, k};
        preconditioned_ = residual_;
        factor_.solve(preconditioned_, pool);
        const double energy = dot(residual_, preconditioned_, pool);
        if (k == 0) {
            std::swap(direction_, preconditioned_);
        } else {
            pool.parallel_for(x.size(), [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    direction_[i] = preconditioned_[i] + (energy / last_energy) * direction_[i];
            });
        }
        last_energy = energy;
        matrix_->multiply(pattern_, direction_, image_, pool);
        const double curvature = dot(direction_, image_, pool);
        if (!(curvature > 0)) return {false, k + 1};  // rounding, or an indefinite matrix
        const double step = energy / curvature;
        const auto update = [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i) {
                x[i] += step * direction_[i];
                residual_[i] -= step * image_[i];
                sum += weighted_square(residual_[i], weight_[i]);
            }
            return sum;
        };
        residual_square = pool.parallel_reduce(x.size(), 0.0, update, std::plus<>());
    }
    return {false, max_iterations + 1};
}

RefinedFactor::SquaredNorms RefinedFactor::reset_residual(std::span<Vec6> x, std::span<const Vec6> b,
                                                          const ThreadPool& pool) {
    image_.resize(b.size());
    residual_.resize(b.size());
    matrix_->multiply(pattern_, x, image_, pool);
    const auto chunk_value = [&](std::size_t begin, std::size_t end) {
        SquaredNorms squared_norms;
        for (std::size_t i = begin; i < end; ++i) {
            residual_[i] = b[i] - image_[i];
            squared_norms.residual += weighted_square(residual_[i], weight_[i]);
            squared_norms.load += weighted_square(b[i], weight_[i]);
        }
        return squared_norms;
    };
    const auto add = [](const SquaredNorms& sum, const SquaredNorms& more) {
        return SquaredNorms{sum.residual + more.residual, sum.load + more.load};
    };
    SquaredNorms squared_norms = pool.parallel_reduce(b.size(), SquaredNorms(), chunk_value, add);
    if (squared_norms.residual <= squared_norms.load) return squared_norms;
    std::fill(x.begin(), x.end(), Vec6::Zero());
    residual_.assign(b.begin(), b.end());
    squared_norms.residual = squared_norms.load;
    return squared_norms;
}

}  // namespace rockslope::dda
