#include "dda/linear/front_kernels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <cstring>
#include <vector>

#include "dda/linear/aligned_buffer.hpp"
#include "dda/linear/symbolic_factor.hpp"
#include "support/sanitized.hpp"
#include "unit/dda/linear/random_systems.hpp"

namespace rockslope::front_kernels_test {
namespace {

/// A random positive definite front, as a dense matrix and as the panel that the kernels work on.
template <class Scalar>
class DenseFront {
  public:
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    static constexpr int w = dda::strip_rows<Scalar>;

    DenseFront(int pivot_blocks, int row_blocks, unsigned seed)
        : pivots(pivot_blocks), rows(row_blocks), columns(6 * pivots), padded((columns + w - 1) / w * w) {
        RandomNumbers draw(seed);
        const int size = columns + 6 * rows;
        const Matrix root =
            Matrix::NullaryExpr(size, size, [&] { return static_cast<Scalar>(draw.number()); });
        matrix = root * root.transpose() + Matrix::Identity(size, size) * static_cast<Scalar>(size) / 4;
        strips = (columns + w - 1) / w + (6 * rows + w - 1) / w;
        const std::size_t length =
            dda::diagonal_blocks_size<Scalar>(pivots) + static_cast<std::size_t>(strips * w * columns);
        panel_.resize(length);
        std::fill_n(panel_.data(), length, Scalar(0));
        for (int c = 0; c < columns; ++c) {
            for (int r = c / 6 * 6; r < size; ++r) at(r, c) = matrix(r, c);
        }
    }
    /// A scalar of the panel, by its row and column in the dense matrix.
    Scalar& at(int row, int column) {
        const int r = row < columns ? row : row - columns + padded;
        return panel_.data()[dda::diagonal_blocks_size<Scalar>(pivots) +
                             static_cast<std::size_t>(((r / w) * columns + column) * w + r % w)];
    }
    int row_strips() const { return (6 * rows + w - 1) / w; }
    int pivot_strips() const { return padded / w; }
    Scalar* panel() { return panel_.data(); }

    int pivots, rows, columns, padded, strips = 0;
    Matrix matrix;

  private:
    dda::AlignedBuffer<Scalar> panel_;
};

/// A scalar of an update, by its row and column.
template <class Scalar>
Scalar at_update(const Scalar* update, int row, int column, int stride) {
    constexpr std::size_t w = dda::strip_rows<Scalar>;
    const auto j = static_cast<std::size_t>(column / 6);
    const auto height = static_cast<std::size_t>(stride);
    return update[dda::update_column_offset(j, height, w) +
                  static_cast<std::size_t>(column % 6) * dda::update_column_stride(j, height, w) +
                  static_cast<std::size_t>(row)];
}

template <class Scalar>
class FrontKernels : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(FrontKernels, Scalars);

/// Runs `check(kernels, front)` for all kernel sets and for fronts of many shapes.
template <class Scalar, class Check>
void for_fronts(const Check& check) {
    for (const auto& kernels : dda::front_kernels<Scalar>()) {
        for (const int pivots : {1, 2, 3, 4, 5, 8, 13}) {
            for (const int rows : {0, 1, 2, 3, 5, 6, 11, 24}) {
                DenseFront<Scalar> front(pivots, rows, static_cast<unsigned>(100 * pivots + rows));
                SCOPED_TRACE(std::to_string(pivots) + " pivots, " + std::to_string(rows) + " rows, set " +
                             std::to_string(&kernels - dda::front_kernels<Scalar>().data()));
                check(kernels, front);
            }
        }
    }
}

// The condition number is below 100 by construction, so the differences are a few roundings of the entries.
TYPED_TEST(FrontKernels, FactoriseAFront) {
    using Scalar = TypeParam;
    using Matrix = typename DenseFront<Scalar>::Matrix;
    const double tolerance = 1e3 * std::numeric_limits<Scalar>::epsilon();
    for_fronts<Scalar>([&](const dda::FrontKernels<Scalar>& kernels, DenseFront<Scalar>& front) {
        const int k = front.columns;
        const int m = 6 * front.rows;
        ASSERT_TRUE(kernels.factor_pivots(front.panel(), front.pivots, 0, front.pivots));
        kernels.solve_rows(front.panel(), front.pivots, 0, front.row_strips());
        const Matrix l = front.matrix.topLeftCorner(k, k).llt().matrixL();
        Matrix below(m, k);
        if (m > 0)
            below = l.template triangularView<Eigen::Lower>()
                        .solve(front.matrix.bottomLeftCorner(m, k).transpose())
                        .transpose();
        const double size = static_cast<double>(front.matrix.norm());
        double worst = 0;
        for (int c = 0; c < k; ++c) {
            for (int r = c / 6 * 6 + 6; r < k; ++r)
                worst = std::max(worst, double(std::abs(front.at(r, c) - l(r, c))));
            for (int r = 0; r < c / 6 * 6; ++r) EXPECT_EQ(front.at(r, c), 0);
            for (int r = 0; r < m; ++r)
                worst = std::max(worst, double(std::abs(front.at(k + r, c) - below(r, c))));
        }
        EXPECT_LT(worst, tolerance * size);
        if (m == 0) return;

        const int stride = front.row_strips() * DenseFront<Scalar>::w;
        dda::AlignedBuffer<Scalar> update;
        update.resize(static_cast<std::size_t>(stride * m + 1));
        kernels.form_update(front.panel(), front.pivots, front.row_strips(), {update.data(), stride}, 0,
                            front.rows);
        const Matrix product = -below * below.transpose();
        worst = 0;
        for (int c = 0; c < m; ++c) {
            for (int r = c; r < m; ++r)
                worst =
                    std::max(worst, double(std::abs(at_update(update.data(), r, c, stride) - product(r, c))));
        }
        EXPECT_LT(worst, tolerance * size);
    });
}

TYPED_TEST(FrontKernels, Solve) {
    using Scalar = TypeParam;
    using Vector = typename DenseFront<Scalar>::Vector;
    const double tolerance = 1e3 * std::numeric_limits<Scalar>::epsilon();
    for_fronts<Scalar>([&](const dda::FrontKernels<Scalar>& kernels, DenseFront<Scalar>& front) {
        const int k = front.columns;
        const int m = 6 * front.rows;
        if (m == 0) return;  // a root, which the tests of the factor cover
        ASSERT_TRUE(kernels.factor_pivots(front.panel(), front.pivots, 0, front.pivots));
        kernels.solve_rows(front.panel(), front.pivots, 0, front.row_strips());
        kernels.invert_groups(front.panel(), front.pivots);
        const auto a11 = front.matrix.topLeftCorner(k, k);
        const auto a21 = front.matrix.bottomLeftCorner(m, k);
        RandomNumbers draw(3);
        const Vector b = Vector::NullaryExpr(k + m, [&] { return static_cast<Scalar>(draw.number()); });

        dda::AlignedBuffer<Scalar> x;
        x.resize(static_cast<std::size_t>(front.strips * DenseFront<Scalar>::w));
        std::fill_n(x.data(), front.strips * DenseFront<Scalar>::w, Scalar(0));
        Eigen::Map<Vector> top(x.data(), k);
        Eigen::Map<Vector> rest(x.data() + front.padded, m);
        top = b.head(k);
        rest = b.tail(m);
        kernels.forward(front.panel(), front.pivots, front.strips, x.data());
        const Vector eliminated = b.tail(m) - a21 * a11.llt().solve(b.head(k));
        EXPECT_LT(double((rest - eliminated).norm()), tolerance * (1 + m));
        rest = b.tail(m);
        kernels.backward(front.panel(), front.pivots, front.strips, x.data());
        const Vector expected = a11.llt().solve(b.head(k) - a21.transpose() * b.tail(m));
        EXPECT_LT(double((top - expected).norm()), tolerance * (1 + m));
    });
}

TYPED_TEST(FrontKernels, GiveTheSameBytesInChunks) {
    using Scalar = TypeParam;
    for_fronts<Scalar>([&](const dda::FrontKernels<Scalar>& kernels, DenseFront<Scalar>& front) {
        DenseFront<Scalar> other(front.pivots, front.rows,
                                 static_cast<unsigned>(100 * front.pivots + front.rows));
        const std::size_t stride = static_cast<std::size_t>(front.row_strips() * DenseFront<Scalar>::w);
        const std::size_t columns = static_cast<std::size_t>(6 * front.rows);
        dda::AlignedBuffer<Scalar> whole, parts;
        whole.resize(stride * columns + 1);
        parts.resize(stride * columns + 1);
        ASSERT_TRUE(kernels.factor_pivots(front.panel(), front.pivots, 0, front.pivots));
        constexpr int w = DenseFront<Scalar>::w;
        for (int begin = 0; begin < front.pivots; begin += 3) {
            const int end = std::min(begin + 3, front.pivots);
            ASSERT_TRUE(kernels.factor_pivots(other.panel(), front.pivots, begin, end));
            for (int s = front.padded / w - 1; s >= (6 * end + w - 1) / w; --s)
                kernels.solve_pivot_rows(other.panel(), front.pivots, begin, end, s, s + 1);
        }
        kernels.solve_rows(front.panel(), front.pivots, 0, front.row_strips());
        for (int s = front.row_strips() - 1; s >= 0; --s)
            kernels.solve_rows(other.panel(), front.pivots, s, s + 1);
        for (int c = 0; c < front.columns; ++c) {
            for (int r = c / 6 * 6 + 6; r < front.columns + 6 * front.rows; ++r)
                ASSERT_EQ(front.at(r, c), other.at(r, c));
        }
        kernels.form_update(front.panel(), front.pivots, front.row_strips(),
                            {whole.data(), static_cast<long>(stride)}, 0, front.rows);
        for (int j = front.rows; j > 0; j -= 2)
            kernels.form_update(front.panel(), front.pivots, front.row_strips(),
                                {parts.data(), static_cast<long>(stride)}, std::max(j - 2, 0), j);
        for (std::size_t c = 0; c < columns; ++c) {
            for (std::size_t r = c; r < columns; ++r)
                ASSERT_EQ(at_update(whole.data(), int(r), int(c), int(stride)),
                          at_update(parts.data(), int(r), int(c), int(stride)));
        }
    });
}

/// What the kernels make of a front: its factor, its update, and solutions with it.
template <class Scalar>
std::vector<Scalar> results_of(const dda::FrontKernels<Scalar>& kernels, DenseFront<Scalar>& front) {
    constexpr int w = DenseFront<Scalar>::w;
    const int stride = front.row_strips() * w;
    dda::AlignedBuffer<Scalar> update, x;
    update.resize(static_cast<std::size_t>(stride * 6 * front.rows + 1));
    x.resize(static_cast<std::size_t>(front.strips * w));
    std::fill_n(x.data(), front.strips * w, Scalar(0));
    RandomNumbers draw(5);
    for (int r = 0; r < front.columns; ++r) x.data()[r] = static_cast<Scalar>(draw.number());
    EXPECT_TRUE(kernels.factor_pivots(front.panel(), front.pivots, 0, front.pivots));
    kernels.solve_rows(front.panel(), front.pivots, 0, front.row_strips());
    kernels.form_update(front.panel(), front.pivots, front.row_strips(), {update.data(), stride}, 0,
                        front.rows);
    kernels.invert_groups(front.panel(), front.pivots);
    std::vector<Scalar> results;
    for (int c = 0; c < front.columns; ++c)
        for (int r = c; r < front.columns + 6 * front.rows; ++r) results.push_back(front.at(r, c));
    for (int c = 0; c < 6 * front.rows; ++c)
        for (int r = c; r < 6 * front.rows; ++r) results.push_back(at_update(update.data(), r, c, stride));
    kernels.forward(front.panel(), front.pivots, front.strips, x.data());
    results.insert(results.end(), x.data(), x.data() + front.columns);
    results.insert(results.end(), x.data() + front.padded, x.data() + front.padded + 6 * front.rows);
    for (int r = 0; r < 6 * front.rows; ++r) x.data()[front.padded + r] = static_cast<Scalar>(draw.number());
    kernels.backward(front.panel(), front.pivots, front.strips, x.data());
    results.insert(results.end(), x.data(), x.data() + front.columns);
    return results;
}

// A shaken slope of 120 blocks ended at 0.40 to 0.68 m, depending on the vectors of the processor.
TYPED_TEST(FrontKernels, GiveTheSameBytesWithVectorsOfAnyWidth) {
    using Scalar = TypeParam;
    const auto& first = dda::front_kernels<Scalar>().front();
    for_fronts<Scalar>([&](const dda::FrontKernels<Scalar>& kernels, DenseFront<Scalar>& front) {
        EXPECT_EQ(kernels.fused, first.fused);
        DenseFront<Scalar> same(front.pivots, front.rows,
                                static_cast<unsigned>(100 * front.pivots + front.rows));
        const std::vector<Scalar> expected = results_of(first, same);
        const std::vector<Scalar> found = results_of(kernels, front);
        ASSERT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(Scalar)), 0)
            << kernels.name << " and " << first.name;
    });
}

#if defined(__OPTIMIZE__)  // compilers fuse nothing otherwise
// One pivot: each entry below it is a sum of five products at most, in the order of the columns.
TYPED_TEST(FrontKernels, AddFusedProductsInTheOrderOfColumns) {
    if (libraries_are_sanitized())
        GTEST_SKIP() << "a compiler fuses nothing between the checks of a sanitizer";
    using Scalar = TypeParam;
    for (const auto& kernels : dda::front_kernels<Scalar>()) {
        if (!kernels.fused) continue;
        DenseFront<Scalar> front(1, 5, 7), factor(1, 5, 7);
        ASSERT_TRUE(kernels.factor_pivots(factor.panel(), 1, 0, 1));
        kernels.solve_rows(factor.panel(), 1, 0, factor.row_strips());
        for (int r = 6; r < 36; ++r) {
            for (int c = 0; c < 6; ++c) {
                Scalar sum = front.at(r, c);
                for (int p = 0; p < c; ++p) sum = std::fma(-factor.at(r, p), factor.panel()[c * 6 + p], sum);
                ASSERT_EQ(factor.at(r, c), sum * factor.panel()[c * 6 + c]) << kernels.name;
            }
        }
    }
}
#endif

TYPED_TEST(FrontKernels, RejectAnIndefiniteMatrix) {
    using Scalar = TypeParam;
    for_fronts<Scalar>([&](const dda::FrontKernels<Scalar>& kernels, DenseFront<Scalar>& front) {
        const int middle = front.columns / 2;
        front.at(middle, middle) = -1;
        EXPECT_FALSE(kernels.factor_pivots(front.panel(), front.pivots, 0, front.pivots));
    });
}

}  // namespace
}  // namespace rockslope::front_kernels_test
