#pragma once

#include <span>

namespace rockslope::dda {

/// The dense work on a front. A panel's rows are stored in strips: scalar (r, c) of a panel of k block
/// columns is at ((r / w) * 6 k + c) * w + r % w, w = strip_rows<Scalar>, so that work on a few rows reads
/// memory straight ahead. Above the diagonal submatrices a panel is zero. Before the strips are the factors
/// of the diagonal submatrices, 36 scalars each by rows, with the reciprocals of their diagonals.
///
/// One set of them for each width of the processor's vectors; each gives the same bytes for the same panel,
/// whoever calls it and in whatever chunks.
template <class Scalar>
struct FrontKernels {
    /// Factorises the pivots' square. @return false when it is not positive definite.
    bool (*factor_pivots)(Scalar* panel, int pivots);
    /// L21 = A21 L11^-T in strips [begin, end) of the rows that the front reaches.
    void (*solve_rows)(Scalar* panel, int pivots, int begin, int end);
    /// Block columns [begin, end) of -L21 L21^T, on and below the diagonal.
    void (*form_update)(const Scalar* panel, int pivots, int row_strips, Scalar* update, long stride,
                        int begin, int end);
    /// Inverts, in the pivots' square, groups of block columns on the diagonal: substitutions read those. The
    /// rows have to be solved before.
    void (*invert_groups)(Scalar* panel, int pivots);
    /// x, by rows of the panel: solves L11 y = x1 and takes L21 y from x2.
    void (*forward)(const Scalar* panel, int pivots, int strips, Scalar* x);
    /// Solves L11^T x1 = y1 - L21^T x2.
    void (*backward)(const Scalar* panel, int pivots, int strips, Scalar* x);
};

/// The sets that this processor can run, the widest first.
template <class Scalar>
std::span<const FrontKernels<Scalar>> front_kernels();

extern template std::span<const FrontKernels<float>> front_kernels();
extern template std::span<const FrontKernels<double>> front_kernels();

}  // namespace rockslope::dda
