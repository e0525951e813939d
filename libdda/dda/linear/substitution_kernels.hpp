#pragma once

#include <utility>

#include "dda/linear/strips.hpp"

namespace rockslope::dda {

/// Forward and backward substitution with a front's panel, by groups of block columns. A substitution reads
/// the factor once and is limited by memory bandwidth, unless each number waits for the one before. The
/// diagonal block of each group is therefore inverted beforehand, and all work is matrix-vector products.
template <class Scalar, int Bytes>
struct Substitution : Strips<Scalar, Bytes> {
    using S = Strips<Scalar, Bytes>;
    using Vector = typename S::Vector;
    using S::lanes, S::load, S::per_strip, S::row_at, S::store, S::unknowns, S::vector_at, S::w;

    /// Block columns in a group, for vectors of any width: sums are grouped alike. With 64 bytes the partial
    /// sums of a group fill the registers.
    static constexpr int group = 3;
    static constexpr int group_columns = group * unknowns;
    /// Columns whose partial sums, one for each row of a strip, fit the registers at a time.
    static constexpr int columns_at_once = Bytes == 64   ? group_columns
                                           : Bytes == 32 ? unknowns
                                                         : unknowns / 2;
    /// Largest number of vectors that contain rows of a group. A group begins at an even row.
    static constexpr int group_vectors = (lanes - 2 + group_columns + lanes - 1) / lanes;

    DDA_KERNEL static int vectors_up_to(int row) { return (row + lanes - 1) / lanes; }

    /// Inverts the diagonal block L of a group in place. Column c of M = L^-1 follows from the later columns,
    /// since M L = I.
    /// @param squares factors of the 6x6 diagonal blocks, which hold the reciprocals of the diagonal.
    DDA_KERNEL static void invert_group(const Scalar* squares, Scalar* strips, int columns, int first,
                                        int last) {
        constexpr int height = group_vectors * lanes;
        const int begin = first / lanes;
        const int before = first - begin * lanes;  // rows of the first vector that precede the group
        const Scalar* rows[group_columns];
        for (int k = 0; k < last - first; ++k) rows[k] = strips + row_at(first + k, columns);
        Scalar ones[2 * height] = {};
        ones[height] = 1;
        Vector inverse[group_columns][group_vectors];
        for (int c = last - first; c-- > 0;) {
            const Scalar* square = squares + (first + c) / unknowns * unknowns * unknowns;
            const int in_square = c % unknowns;
            const int next = c - in_square + unknowns;
            Vector sum[group_vectors];
            __builtin_memcpy(sum, ones + (height - before - c), sizeof(sum));
            for (int k = last - first; k-- > c + 1;) {
                const Scalar factor = k < next ? square[(k - next + unknowns) * unknowns + in_square]
                                               : rows[k][static_cast<long>(first + c) * w];
                for (int v = 0; v < group_vectors; ++v) sum[v] -= inverse[k][v] * factor;
            }
            for (int v = 0; v < group_vectors; ++v)
                inverse[c][v] = sum[v] * square[in_square * unknowns + in_square];
        }
        alignas(Vector) Scalar others[height];  // 1 in rows outside the group
        for (int r = 0; r < height; ++r) others[r] = r < before || r >= before + last - first ? 1 : 0;
        const int count = vectors_up_to(last) - begin;
        for (int v = 0; v < count; ++v) {
            Scalar* at = strips + vector_at(begin + v, columns) + static_cast<long>(first) * w;
            for (int c = 0; c < last - first; ++c, at += w)
                store(load(at).vector * load(others + v * lanes).vector + inverse[c][v], at);
        }
    }
    DDA_KERNEL static void invert_groups(Scalar* panel, int pivots) {
        const int columns = pivots * unknowns;
        Scalar* strips = panel + diagonal_blocks_size<Scalar>(pivots);
        for (int first = 0; first < columns; first += group_columns) {
            const int last = first + group_columns < columns ? first + group_columns : columns;
            invert_group(panel, strips, columns, first, last);
        }
    }

    /// `count` columns of a panel from `first` on.
    struct PanelColumns {
        const Scalar* strips;
        int columns;  ///< of the panel
        int first;
        int count;

        /// The first of these columns in a vector of rows.
        DDA_KERNEL const Scalar* in_vector(int vector) const {
            return strips + vector_at(vector, columns) + static_cast<long>(first) * w;
        }
    };

    /// sum = A y for R vectors of rows; the number of columns is even.
    template <int R>
    DDA_KERNEL static void multiply(Vector (&sum)[R], const PanelColumns& a, int first_vector,
                                    const Scalar* y) {
        const Scalar* rows[R];
        Vector odd[R];
        for (int r = 0; r < R; ++r) {
            rows[r] = a.in_vector(first_vector + r);
            sum[r] = odd[r] = Vector{};
        }
        for (int c = 0; c < a.count; c += 2) {
            const long p = static_cast<long>(c) * w;
            const Scalar y0 = y[c];
            const Scalar y1 = y[c + 1];
#pragma GCC unroll 4
            for (int r = 0; r < R; ++r) {
                sum[r] += load(rows[r] + p).vector * y0;
                odd[r] += load(rows[r] + p + w).vector * y1;
            }
        }
        for (int r = 0; r < R; ++r) sum[r] += odd[r];
    }
    /// x -= A y for the same rows and columns.
    template <int R>
    DDA_KERNEL static void subtract_products(const PanelColumns& a, int first_vector, const Scalar* y,
                                             Scalar* x) {
        Vector sum[R];
        multiply<R>(sum, a, first_vector, y);
        for (int r = 0; r < R; ++r) {
            Scalar* at = x + static_cast<long>(first_vector + r) * lanes;
            store(load(at).vector - sum[r], at);
        }
    }

    DDA_KERNEL static void forward(const Scalar* panel, int pivots, int strips, Scalar* x) {
        const int columns = pivots * unknowns;
        const Scalar* below = panel + diagonal_blocks_size<Scalar>(pivots);
        for (int first = 0; first < columns; first += group_columns) {
            const int last = first + group_columns < columns ? first + group_columns : columns;
            const int begin = first / lanes;
            const PanelColumns group_of_columns{below, columns, first, last - first};
            alignas(Vector) Scalar own[group_vectors * lanes] = {};
            for (int v = begin; v < vectors_up_to(last); ++v) {
                Vector sum[1];
                multiply<1>(sum, group_of_columns, v, x + first);
                store(sum[0], own + (v - begin) * lanes);
            }
            const Scalar* y = own + (first - begin * lanes);
            int v = last < columns ? last / lanes : vectors_up_to(last);
            for (; v + 4 <= strips * per_strip; v += 4) subtract_products<4>(group_of_columns, v, y, x);
            if (v + 2 <= strips * per_strip) {
                subtract_products<2>(group_of_columns, v, y, x);
                v += 2;
            }
            if (v < strips * per_strip) subtract_products<1>(group_of_columns, v, y, x);
            for (int c = first; c < last; ++c) x[c] = y[c - first];
        }
    }

    /// sum += L^T x for N columns and strips [begin, end) of rows, before the lanes are summed. Each row of a
    /// strip has a partial sum of its own, whatever the width of the vectors.
    /// @param x begins with the strip of rows `origin`.
    template <int N>
    DDA_KERNEL static void add_products(Vector (&sum)[N][per_strip], const PanelColumns& l, int begin,
                                        int end, const Scalar* x, int origin) {
        for (int s = begin; s < end; ++s) {
#pragma GCC unroll 4
            for (int v = 0; v < per_strip; ++v) {
                const Scalar* at = l.in_vector(s * per_strip + v);
                const Vector factor = load(x + static_cast<long>(s - origin) * w + v * lanes).vector;
#pragma GCC unroll 18
                for (int q = 0; q < N; ++q) sum[q][v] += load(at + q * w).vector * factor;
            }
        }
    }

    /// One step of a horizontal sum. Vectors a and b hold groups of 2 * Half lanes; `sum` gets, for each
    /// group, its two halves added.
    template <int Half, std::size_t... Lane>
    DDA_KERNEL static void add_halves(const Vector& a, const Vector& b, Vector& sum,
                                      std::index_sequence<Lane...>) {
        sum = __builtin_shufflevector(a, b, (Lane / Half * 2 * Half + Lane % Half)...) +
              __builtin_shufflevector(a, b, (Lane / Half * 2 * Half + Lane % Half + Half)...);
    }
    /// sums[k] = sum of the lanes of vectors[k].
    template <int N, int Half = lanes / 2>
    DDA_KERNEL static void sum_lanes(const Vector (&vectors)[N], Scalar* sums) {
        constexpr int pairs = (N + 1) / 2;
        Vector halved[pairs];
#pragma GCC unroll 18
        for (int k = 0; k < pairs; ++k)
            add_halves<Half>(vectors[2 * k], vectors[2 * k + 1 < N ? 2 * k + 1 : 2 * k], halved[k],
                             std::make_index_sequence<lanes>());
        if constexpr (Half == 1) {
            for (int k = 0; k < pairs; ++k) store(halved[k], sums + k * lanes);
        } else {
            sum_lanes<pairs, Half / 2>(halved, sums);
        }
    }

    /// sums = L^T x for `Count` columns and strips [begin, end) of rows, see add_products(). The rows of a
    /// strip are summed by halves, the same for vectors of any width.
    template <int Count>
    DDA_KERNEL static void products(const PanelColumns& l, int begin, int end, const Scalar* x, int origin,
                                    Scalar* sums) {
        constexpr int group = Count < columns_at_once ? Count : columns_at_once;
        static_assert(Count % group == 0);
        Vector whole[Count];
        for (int first = 0; first < Count; first += group) {
            Vector sum[group][per_strip] = {};
            const PanelColumns some{l.strips, l.columns, l.first + first, group};
            add_products<group>(sum, some, begin, end, x, origin);
#pragma GCC unroll 18
            for (int q = 0; q < group; ++q) {
#pragma GCC unroll 2
                for (int half = per_strip / 2; half > 0; half /= 2) {
                    for (int v = 0; v < half; ++v) sum[q][v] += sum[q][v + half];
                }
                whole[first + q] = sum[q][0];
            }
        }
        sum_lanes<Count>(whole, sums);
    }

    /// Backward substitution of a group of N block columns.
    /// @param strip_count of the whole panel.
    template <int N>
    DDA_KERNEL static void group_backward(const Scalar* strips, int columns, int first, int strip_count,
                                          Scalar* x) {
        constexpr int count = N * unknowns;
        const int last = first + count;
        const int begin = first / w;
        const int end = (last + w - 1) / w;
        constexpr int group_strips = (w - 2 + group_columns + w - 1) / w;
        alignas(Vector) Scalar y[group_strips * w] = {};
        Scalar* own = y + (first - begin * w);
        for (int c = 0; c < count; ++c) own[c] = x[first + c];
        if (last < columns) {
            for (int c = 0; c < count; ++c) x[first + c] = 0;
        }
        const PanelColumns group_of_columns{strips, columns, first, count};
        alignas(Vector) Scalar sums[(count + lanes - 1) / lanes * lanes];
        products<count>(group_of_columns, last < columns ? last / w : end, strip_count, x, 0, sums);
        for (int c = 0; c < count; ++c) own[c] -= sums[c];
        products<count>(group_of_columns, begin, end, y, begin, sums);
        for (int c = 0; c < count; ++c) x[first + c] = sums[c];
    }

    DDA_KERNEL static void backward(const Scalar* panel, int pivots, int strips, Scalar* x) {
        const int columns = pivots * unknowns;
        const Scalar* below = panel + diagonal_blocks_size<Scalar>(pivots);
        const int rest = pivots % group;
        const int first = (pivots - rest) * unknowns;
        if (rest == 1) group_backward<1>(below, columns, first, strips, x);
        if (rest == 2) group_backward<2>(below, columns, first, strips, x);
        for (int column = first - group_columns; column >= 0; column -= group_columns)
            group_backward<group>(below, columns, column, strips, x);
    }
};

}  // namespace rockslope::dda
