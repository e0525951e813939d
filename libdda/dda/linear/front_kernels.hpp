#pragma once

#include <span>

namespace rockslope::dda {

/// Where the update of a front is written, by block columns.
template <class Scalar>
struct FrontUpdate {
    Scalar* scalars;
    long stride;  ///< scalars from one column of the first block column to the next
};

/// Six columns of a matrix that is stored by columns.
template <class Scalar>
struct SixColumns {
    Scalar* scalars;
    long stride;  ///< scalars from one column to the next
};

/// The dense kernels of a front. The rows of a panel are stored in strips: scalar (r, c) of a panel of k
/// block columns is at ((r / w) * 6 k + c) * w + r % w, w = strip_rows<Scalar>, so that work on a few rows
/// reads memory sequentially. The panel is zero above its diagonal blocks. The factors of the diagonal
/// blocks precede the strips, 36 scalars each by rows, with the reciprocals of their diagonals.
///
/// There is one set of kernels for each vector width of the processor. A set gives the same bytes for the
/// same panel on any thread and in any chunks. All sets with fused arithmetic give the same bytes: each sum
/// has the same terms in the same order for any width, and each of its terms is one fused multiply-add.
template <class Scalar>
struct FrontKernels {
    /// Factorises the pivot block A11 = L11 L11^T: its block columns [begin, end), in rows up to the end of
    /// the strip that ends their diagonal. Those before `begin` are done. @return false when it is not
    /// positive definite.
    bool (*factor_pivots)(Scalar* panel, int pivots, int begin, int end);
    /// The same columns of L11 in strips [first_strip, end_strip) of the pivot rows, all below those of
    /// factor_pivots.
    void (*solve_pivot_rows)(Scalar* panel, int pivots, int begin, int end, int first_strip, int end_strip);
    /// L21 = A21 L11^-T in strips [begin, end) of the rows below the pivots.
    void (*solve_rows)(Scalar* panel, int pivots, int begin, int end);
    /// Sets block columns [begin, end) of the update to -L21 L21^T, on and below the diagonal.
    void (*form_update)(const Scalar* panel, int pivots, int row_strips, const FrontUpdate<Scalar>& update,
                        int begin, int end);
    /// Inverts the diagonal blocks of L11 in groups of block columns, for the substitutions. Comes after
    /// solve_rows.
    void (*invert_groups)(Scalar* panel, int pivots);
    /// Forward substitution with x = (x1, x2) by rows of the panel: x1 = L11^-1 x1, x2 -= L21 x1.
    void (*forward)(const Scalar* panel, int pivots, int strips, Scalar* x);
    /// Backward substitution: x1 = L11^-T (x1 - L21^T x2).
    void (*backward)(const Scalar* panel, int pivots, int strips, Scalar* x);
    /// c -= a b for matrices of six columns, stored by columns: c and a have `rows` rows, b has six.
    void (*subtract_product)(const SixColumns<Scalar>& c, const SixColumns<const Scalar>& a, const Scalar* b,
                             int rows);
    const char* name;  ///< of the vector extension: "avx512", "avx2", "fma", "plain"
    /// Whether products are added without being rounded first. False for processors without fused
    /// multiply-adds only, whose results differ in the last digits.
    bool fused;
};

/// The sets that this processor can run, the widest vectors first. They give the same bytes.
template <class Scalar>
std::span<const FrontKernels<Scalar>> front_kernels();

/// The set that solvers use: the first of front_kernels(), or the one that the environment variable
/// ROCKSLOPE_KERNEL names, for comparisons.
/// @throws InputError when that is none of front_kernels().
template <class Scalar>
const FrontKernels<Scalar>& chosen_front_kernels();

extern template std::span<const FrontKernels<float>> front_kernels();
extern template std::span<const FrontKernels<double>> front_kernels();
extern template const FrontKernels<float>& chosen_front_kernels();
extern template const FrontKernels<double>& chosen_front_kernels();

}  // namespace rockslope::dda
