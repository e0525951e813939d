#include "dda/linear/front_kernels.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#include "common/base/input_error.hpp"
#include "dda/linear/substitution_kernels.hpp"

namespace rockslope::dda {

namespace {

/// Kernels with vectors of Bytes bytes. A tile of Rows vectors times six columns fills the registers.
template <class Scalar, int Bytes, int Rows>
struct Kernels : Strips<Scalar, Bytes> {
    using S = Strips<Scalar, Bytes>;
    using Vector = typename S::Vector;
    using S::lanes, S::per_strip, S::row_at, S::unknowns, S::vector_at, S::w;

    /// Rows of a panel from `first` on, which is the index of a row or of a vector of rows.
    struct PanelRows {
        const Scalar* strips;
        int first;
    };
    struct VectorRange {
        int begin;
        int end;
    };
    static int strips_of_rows(int rows) { return (rows + w - 1) / w; }

    /// sum -= A B^T over `count` columns. A: R vectors of rows; B: six rows. @param columns of the panels.
    template <int R>
    DDA_KERNEL static void subtract_product(Vector (&sum)[R][unknowns], const PanelRows& a,
                                            const PanelRows& b, int columns, int count) {
        const Scalar* rows[R];
        for (int r = 0; r < R; ++r) rows[r] = a.strips + vector_at(a.first + r, columns);
        const Scalar* factors[unknowns];
        for (int q = 0; q < unknowns; ++q) factors[q] = b.strips + row_at(b.first + q, columns);
        for (long p = 0; p < static_cast<long>(count) * w; p += w) {
            Vector row[R];
#pragma GCC unroll 4
            for (int r = 0; r < R; ++r) row[r] = *reinterpret_cast<const Vector*>(rows[r] + p);
#pragma GCC unroll 6
            for (int q = 0; q < unknowns; ++q) {
                const Scalar factor = factors[q][p];
#pragma GCC unroll 4
                for (int r = 0; r < R; ++r) sum[r][q] -= row[r] * factor;
            }
        }
    }

    /// sum = sum L^-T. @param square factor L of the diagonal block of the six columns.
    template <int R>
    DDA_KERNEL static void solve_diagonal_block(Vector (&sum)[R][unknowns], const Scalar* square) {
#pragma GCC unroll 6
        for (int q = 0; q < unknowns; ++q) {
            const Scalar* row = square + q * unknowns;
#pragma GCC unroll 6
            for (int p = 0; p < q; ++p) {
#pragma GCC unroll 4
                for (int r = 0; r < R; ++r) sum[r][q] -= sum[r][p] * row[p];
            }
#pragma GCC unroll 4
            for (int r = 0; r < R; ++r) sum[r][q] *= row[q];
        }
    }

    template <int R>
    DDA_KERNEL static void load(Vector (&sum)[R][unknowns], const Scalar* panel, int first_vector, int column,
                                int columns) {
        for (int r = 0; r < R; ++r) {
            const Scalar* at = panel + vector_at(first_vector + r, columns) + static_cast<long>(column) * w;
#pragma GCC unroll 6
            for (int q = 0; q < unknowns; ++q) sum[r][q] = *reinterpret_cast<const Vector*>(at + q * w);
        }
    }
    template <int R>
    DDA_KERNEL static void store(const Vector (&sum)[R][unknowns], Scalar* panel, int first_vector,
                                 int column, int columns) {
        for (int r = 0; r < R; ++r) {
            Scalar* at = panel + vector_at(first_vector + r, columns) + static_cast<long>(column) * w;
#pragma GCC unroll 6
            for (int q = 0; q < unknowns; ++q) *reinterpret_cast<Vector*>(at + q * w) = sum[r][q];
        }
    }

    /// Six columns of R vectors of rows. Update: subtracts the products of earlier columns. Solve: solves
    /// with the diagonal block `square`.
    template <int R, bool Update, bool Solve>
    DDA_KERNEL static void columns_of_rows(Scalar* rows, const Scalar* pivots, const Scalar* square,
                                           int first_vector, int column, int columns) {
        Vector sum[R][unknowns];
        load<R>(sum, rows, first_vector, column, columns);
        if (Update)
            subtract_product<R>(sum, PanelRows{rows, first_vector}, PanelRows{pivots, column}, columns,
                                column);
        if (Solve) solve_diagonal_block<R>(sum, square);
        store<R>(sum, rows, first_vector, column, columns);
    }

    template <bool Update, bool Solve>
    DDA_KERNEL static void columns_of_all_rows(Scalar* rows, const Scalar* pivots, const Scalar* square,
                                               VectorRange range, int column, int columns) {
        int v = range.begin;
        for (; v + Rows <= range.end; v += Rows)
            columns_of_rows<Rows, Update, Solve>(rows, pivots, square, v, column, columns);
        if (Rows > 2 && v + 2 <= range.end) {
            columns_of_rows<2, Update, Solve>(rows, pivots, square, v, column, columns);
            v += 2;
        }
        for (; v < range.end; ++v)
            columns_of_rows<1, Update, Solve>(rows, pivots, square, v, column, columns);
    }

    /// Factorises a 6x6 diagonal block into `square`.
    DDA_KERNEL static bool factor_diagonal_block(const Scalar* strips, int column, int columns,
                                                 Scalar* square) {
        for (int q = 0; q < unknowns; ++q) {
            const Scalar* row = strips + row_at(column + q, columns) + static_cast<long>(column) * w;
            for (int p = 0; p < unknowns; ++p)
                square[q * unknowns + p] = p > q ? 0 : row[static_cast<long>(p) * w];
        }
        for (int q = 0; q < unknowns; ++q) {
            Scalar* const at = square + q * unknowns;
            Scalar pivot = at[q];
            for (int p = 0; p < q; ++p) pivot -= at[p] * at[p];
            if (!(pivot > 0)) return false;
            const Scalar reciprocal = 1 / std::sqrt(pivot);
            for (int row = q + 1; row < unknowns; ++row) {
                Scalar* const below = square + row * unknowns;
                for (int p = 0; p < q; ++p) below[q] -= below[p] * at[p];
                below[q] *= reciprocal;
            }
            at[q] = reciprocal;
        }
        return true;
    }

    DDA_KERNEL static bool factor_pivots(Scalar* panel, int pivots, int begin, int end) {
        const int columns = pivots * unknowns;
        const int vectors = strips_of_rows(end * unknowns) * per_strip;
        Scalar* strips = panel + diagonal_blocks_size<Scalar>(pivots);
        for (int column = begin * unknowns; column < end * unknowns; column += unknowns) {
            columns_of_all_rows<true, false>(strips, strips, panel, VectorRange{column / lanes, vectors},
                                             column, columns);
            Scalar* square = panel + column * unknowns;
            if (!factor_diagonal_block(strips, column, columns, square)) return false;
            columns_of_all_rows<false, true>(
                strips, strips, square, VectorRange{(column + unknowns) / lanes, vectors}, column, columns);
            for (int row = column / lanes * lanes; row < column; ++row) {
                for (int p = 0; p < unknowns; ++p)
                    strips[row_at(row, columns) + static_cast<long>(column + p) * w] = 0;
            }
        }
        return true;
    }

    DDA_KERNEL static void solve_pivot_rows(Scalar* panel, int pivots, int begin, int end, int first_strip,
                                            int end_strip) {
        const int columns = pivots * unknowns;
        Scalar* strips = panel + diagonal_blocks_size<Scalar>(pivots);
        for (int column = begin * unknowns; column < end * unknowns; column += unknowns)
            columns_of_all_rows<true, true>(strips, strips, panel + column * unknowns,
                                            VectorRange{first_strip * per_strip, end_strip * per_strip},
                                            column, columns);
    }

    DDA_KERNEL static void solve_rows(Scalar* panel, int pivots, int begin, int end) {
        const int columns = pivots * unknowns;
        Scalar* strips = panel + diagonal_blocks_size<Scalar>(pivots);
        Scalar* rows = strips + static_cast<long>(strips_of_rows(columns)) * w * columns;
        // Few strips in a pass, so that they stay in the cache for all columns.
        constexpr int vectors_per_pass = Rows > per_strip ? Rows : per_strip;
        for (int v = begin * per_strip; v < end * per_strip; v += vectors_per_pass) {
            const int last = v + vectors_per_pass < end * per_strip ? v + vectors_per_pass : end * per_strip;
            for (int column = 0; column < columns; column += unknowns)
                columns_of_all_rows<true, true>(rows, strips, panel + column * unknowns, VectorRange{v, last},
                                                column, columns);
        }
    }

    template <int R>
    DDA_KERNEL static void form_tile(const Scalar* rows, int first_vector, int column, int columns,
                                     Scalar* update, long stride) {
        Vector sum[R][unknowns] = {};
        subtract_product<R>(sum, PanelRows{rows, first_vector}, PanelRows{rows, column}, columns, columns);
        const auto j = static_cast<std::size_t>(column / unknowns);
        const int first_row = first_update_row(j, w);
        Scalar* block_column = update + update_column_offset(j, static_cast<std::size_t>(stride), w);
        for (int r = 0; r < R; ++r) {
            if ((first_vector + r) * lanes < first_row) continue;
#pragma GCC unroll 6
            for (int q = 0; q < unknowns; ++q) {
                Scalar* at =
                    block_column + q * (stride - first_row) + static_cast<long>(first_vector + r) * lanes;
                *reinterpret_cast<Vector*>(at) = sum[r][q];
            }
        }
    }

    DDA_KERNEL static void form_update(const Scalar* panel, int pivots, int row_strips,
                                       const FrontUpdate<Scalar>& update, int begin, int end) {
        const int columns = pivots * unknowns;
        const Scalar* rows = panel + diagonal_blocks_size<Scalar>(pivots) +
                             static_cast<long>((columns + w - 1) / w) * w * columns;
        const int vectors = row_strips * per_strip;
        // End of the block columns in which these vectors of rows are on or below the diagonal.
        const auto column_end = [&](int v, int count) {
            const int diagonal_end = ((v + count) * lanes + unknowns - 1) / unknowns;
            return diagonal_end < end ? diagonal_end : end;
        };
        int v = begin * unknowns / lanes;
        for (; v + Rows <= vectors; v += Rows) {
            for (int j = begin; j < column_end(v, Rows); ++j)
                form_tile<Rows>(rows, v, j * unknowns, columns, update.scalars, update.stride);
        }
        for (; v < vectors; ++v) {
            for (int j = begin; j < column_end(v, 1); ++j)
                form_tile<1>(rows, v, j * unknowns, columns, update.scalars, update.stride);
        }
    }

    DDA_KERNEL static void subtract_product_of_columns(const SixColumns<Scalar>& c,
                                                       const SixColumns<const Scalar>& a, const Scalar* b,
                                                       int count) {
        int r = 0;
        for (; r + lanes <= count; r += lanes) {
            Vector sum[unknowns];
#pragma GCC unroll 6
            for (int q = 0; q < unknowns; ++q) sum[q] = S::load(c.scalars + q * c.stride + r).vector;
#pragma GCC unroll 6
            for (int p = 0; p < unknowns; ++p) {
                const Vector row = S::load(a.scalars + p * a.stride + r).vector;
#pragma GCC unroll 6
                for (int q = 0; q < unknowns; ++q) sum[q] -= row * b[q * unknowns + p];
            }
#pragma GCC unroll 6
            for (int q = 0; q < unknowns; ++q) S::store(sum[q], c.scalars + q * c.stride + r);
        }
        for (; r < count; ++r) {
            for (int q = 0; q < unknowns; ++q) {
                Scalar sum = c.scalars[q * c.stride + r];
                for (int p = 0; p < unknowns; ++p) sum -= a.scalars[p * a.stride + r] * b[q * unknowns + p];
                c.scalars[q * c.stride + r] = sum;
            }
        }
    }
};

// An attribute cannot stand in parentheses. NOLINTBEGIN(bugprone-macro-parentheses)
/// A set of kernels compiled for the processors named by `attribute`.
#define DDA_KERNEL_SET(name, text, attribute, bytes, rows, fused)                                           \
    template <class Scalar>                                                                                 \
    struct name {                                                                                           \
        using K = Kernels<Scalar, bytes, rows>;                                                             \
        using S = Substitution<Scalar, bytes>;                                                              \
        attribute static bool factor_pivots(Scalar* p, int k, int b, int e) {                               \
            return K::factor_pivots(p, k, b, e);                                                            \
        }                                                                                                   \
        attribute static void solve_pivot_rows(Scalar* p, int k, int b, int e, int s, int t) {              \
            K::solve_pivot_rows(p, k, b, e, s, t);                                                          \
        }                                                                                                   \
        attribute static void solve_rows(Scalar* p, int k, int b, int e) { K::solve_rows(p, k, b, e); }     \
        attribute static void form_update(const Scalar* p, int k, int s, const FrontUpdate<Scalar>& u,      \
                                          int b, int e) {                                                   \
            K::form_update(p, k, s, u, b, e);                                                               \
        }                                                                                                   \
        attribute static void invert_groups(Scalar* p, int k) { S::invert_groups(p, k); }                   \
        attribute static void forward(const Scalar* p, int k, int s, Scalar* x) { S::forward(p, k, s, x); } \
        attribute static void backward(const Scalar* p, int k, int s, Scalar* x) {                          \
            S::backward(p, k, s, x);                                                                        \
        }                                                                                                   \
        attribute static void subtract_product(const SixColumns<Scalar>& c,                                 \
                                               const SixColumns<const Scalar>& a, const Scalar* b, int r) { \
            K::subtract_product_of_columns(c, a, b, r);                                                     \
        }                                                                                                   \
        static constexpr FrontKernels<Scalar> set{                                                          \
            factor_pivots, solve_pivot_rows, solve_rows,       form_update, invert_groups,                  \
            forward,       backward,         subtract_product, text,        fused};                         \
    }
// NOLINTEND(bugprone-macro-parentheses)

// Compilers contract s += a * b to a fused multiply-add where the processor has one, since this file is
// compiled with -ffp-contract=fast. Sums begin with a number, never with a product: of two products that are
// added, the compiler might fuse either.
#if defined(__FMA__) || defined(__aarch64__)
DDA_KERNEL_SET(Plain, "plain", , 16, 2, true);
#else
DDA_KERNEL_SET(Plain, "plain", , 16, 2, false);
#endif
#if defined(__x86_64__)
// A third width, to check that the width does not matter.
DDA_KERNEL_SET(Fma, "fma", [[gnu::target("avx,fma")]], 16, 2, true);
DDA_KERNEL_SET(Avx2, "avx2", [[gnu::target("avx2,fma")]], 32, 2, true);
DDA_KERNEL_SET(Avx512, "avx512", [[gnu::target("avx512f,avx2,fma")]], 64, 3, true);
#endif

}  // namespace

template <class Scalar>
std::span<const FrontKernels<Scalar>> front_kernels() {
#if defined(__x86_64__)
    static const FrontKernels<Scalar> fused[] = {Avx512<Scalar>::set, Avx2<Scalar>::set, Fma<Scalar>::set};
    static const FrontKernels<Scalar> separate[] = {Plain<Scalar>::set};
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    static const bool has_avx512 = has_avx2 && __builtin_cpu_supports("avx512f");
    if (!has_avx2) return separate;
    return std::span<const FrontKernels<Scalar>>(fused).subspan(has_avx512 ? 0 : 1);
#else
    static const FrontKernels<Scalar> sets[] = {Plain<Scalar>::set};
    return sets;
#endif
}

template <class Scalar>
const FrontKernels<Scalar>& chosen_front_kernels() {
    static const FrontKernels<Scalar>& chosen = []() -> const FrontKernels<Scalar>& {
        const char* const wanted = std::getenv("ROCKSLOPE_KERNEL");
        if (wanted == nullptr) return front_kernels<Scalar>().front();
        std::string names;
        for (const FrontKernels<Scalar>& kernels : front_kernels<Scalar>()) {
            if (kernels.name == std::string(wanted)) return kernels;
            names += (names.empty() ? "" : ", ") + std::string(kernels.name);
        }
        throw InputError({"ROCKSLOPE_KERNEL"}, "is '" + std::string(wanted) + "'",
                         "one of the kernels that this processor can run: " + names);
    }();
    return chosen;
}

template std::span<const FrontKernels<float>> front_kernels();
template std::span<const FrontKernels<double>> front_kernels();
template const FrontKernels<float>& chosen_front_kernels();
template const FrontKernels<double>& chosen_front_kernels();

}  // namespace rockslope::dda
