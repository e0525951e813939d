#include "blockgen/report/fisher_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rockslope::blockgen {

namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The square of a symmetric matrix, over its trace.
Matrix squared(const Matrix& m) {
    Matrix square;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) square[i][j] = dot(m[i], m[j]);
    const double trace = square[0][0] + square[1][1] + square[2][2];
    for (Vector& row : square)
        for (double& value : row) value /= trace;
    return square;
}

/// The axis with the largest sum of squared projections: the first eigenvector of the orientation tensor,
/// which high powers of the tensor project on.
Vector principal_axis(std::span<const Pole> poles) {
    constexpr int squarings = 50;
    Matrix tensor{};
    for (const Pole& p : poles) {
        const Vector v{p.x, p.up, p.out};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) tensor[i][j] += v[i] * v[j];
    }
    for (int k = 0; k < squarings; ++k) tensor = squared(tensor);
    return *std::max_element(tensor.begin(), tensor.end(),
                             [](const Vector& a, const Vector& b) { return dot(a, a) < dot(b, b); });
}

}  // namespace

FisherEstimate fisher_estimate(std::span<const Pole> poles) {
    // Below this scatter per pole the sum of squares is lost in rounding.
    constexpr double least_scatter = 1e-12;
    const Vector axis = principal_axis(poles);
    Vector sum{};
    for (const Pole& p : poles) {
        const Vector v{p.x, p.up, p.out};
        const double sign = dot(v, axis) < 0 ? -1 : 1;
        for (std::size_t i = 0; i < 3; ++i) sum[i] += sign * v[i];
    }
    const double length = std::sqrt(dot(sum, sum)), up = sum[1] < 0 ? -1 : 1;
    FisherEstimate estimate;
    estimate.count = poles.size();
    estimate.mean = {up * sum[0] / length, up * sum[1] / length, up * sum[2] / length};
    const auto n = static_cast<double>(poles.size());
    if (n - length > least_scatter * n) estimate.k = (n - 1) / (n - length);
    return estimate;
}

}  // namespace rockslope::blockgen
