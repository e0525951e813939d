#include "dda/linear/envelope_lu.hpp"

#include <Eigen/LU>
#include <cmath>

#include "dda/linear/front_kernels.hpp"

namespace rockslope::dda {

void EnvelopeLu::reset(std::span<const int> last) {
    columns_.resize(last.size());
    inverses_.resize(last.size());
    int first = 0;
    std::size_t begin = 0;
    for (int j = 0; j < size(); ++j) {
        while (last[first] < j) ++first;
        columns_[j] = {first, last[j], begin};
        begin += 6 * static_cast<std::size_t>(columns_[j].stride());
    }
    scalars_.assign(begin, 0);
}

void EnvelopeLu::add(int row, int column, const Mat6& part) {
    block(row, columns_[column]) += part;
}

int EnvelopeLu::factorize() {
    const FrontKernels<double>& kernels = chosen_front_kernels<double>();
    int sign = 1;
    for (int j = 0; j < size(); ++j) {
        const Column& pivot = columns_[j];
        const Mat6 diagonal = block(j, pivot);
        const Eigen::PartialPivLU<Mat6> lu(diagonal);
        const double determinant = lu.determinant();
        if (!(std::abs(determinant) > 0)) return 0;
        if (determinant < 0) sign = -sign;
        inverses_[j] = lu.inverse();
        if (pivot.last == j) continue;
        scale(pivot, j + 1, inverses_[j]);
        const SixColumns<const double> below{&scalars_[pivot.at(j + 1)], pivot.stride()};
        for (int k = j + 1; k <= pivot.last; ++k) {
            const Column& column = columns_[k];
            const Mat6 factor = block(j, column);
            kernels.subtract_product({&scalars_[column.at(j + 1)], column.stride()}, below, factor.data(),
                                     6 * (pivot.last - j));
        }
    }
    return sign;
}

void EnvelopeLu::scale(const Column& pivot, int row, const Mat6& inverse) {
    const int rows = 6 * (pivot.last + 1 - row);
    scaled_.assign(6 * static_cast<std::size_t>(rows), 0);
    const Mat6 negative = -inverse;
    chosen_front_kernels<double>().subtract_product(
        {scaled_.data(), rows}, {&scalars_[pivot.at(row)], pivot.stride()}, negative.data(), rows);
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, 6>;
    Eigen::Map<Columns, 0, Eigen::OuterStride<>>(&scalars_[pivot.at(row)], rows, 6,
                                                 Eigen::OuterStride<>(pivot.stride())) =
        Eigen::Map<const Columns>(scaled_.data(), rows, 6);
}

void EnvelopeLu::solve(std::span<Vec6> x) const {
    // Subtracts the submatrices of rows [begin, end) of a column, times the column's unknowns.
    const auto subtract = [&](int column, int begin, int end) {
        const Column& of = columns_[column];
        const Vec6 factor = x[column];
        const double* scalars = scalars_.data() + of.at(begin);
        const long stride = of.stride();
        double* sum = x[begin].data();
        for (int r = 0; r < 6 * (end - begin); ++r) {
            double rest = sum[r];
            for (int q = 0; q < 6; ++q) rest -= scalars[q * stride + r] * factor[q];
            sum[r] = rest;
        }
    };
    // The forces of one contact are zero on the blocks before its own.
    for (int j = 0; j < size(); ++j)
        if (columns_[j].last > j && !x[j].isZero(0)) subtract(j, j + 1, columns_[j].last + 1);
    for (int j = size() - 1; j >= 0; --j) {
        x[j] = (inverses_[j] * x[j]).eval();
        if (columns_[j].first < j) subtract(j, columns_[j].first, j);
    }
}

}  // namespace rockslope::dda
