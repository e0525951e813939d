#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dda/linear/supernodes.hpp"
#include "dda/linear/task_forest.hpp"

namespace rockslope::dda {

/// Number of rows in a strip. The rows of a front's panel are stored in strips of 64 bytes, see
/// front_kernels.hpp.
template <class Scalar>
inline constexpr int strip_rows = 64 / static_cast<int>(sizeof(Scalar));

/// Number of scalars that precede the strips of a panel: the factors of its 6x6 diagonal blocks, rounded up
/// to whole strips.
constexpr std::size_t diagonal_blocks_size(std::size_t pivots, std::size_t rows_per_strip) {
    return (pivots * 36 + rows_per_strip - 1) / rows_per_strip * rows_per_strip;
}
template <class Scalar>
constexpr std::size_t diagonal_blocks_size(int pivots) {
    return diagonal_blocks_size(pivots, strip_rows<Scalar>);
}

// An update matrix is symmetric, so its block column j is stored from scalar row first_update_row on: the
// first row of the strip that contains the diagonal. `w` is strip_rows, `stride` the scalar rows of the
// update.

/// First scalar row that is stored of block column j.
constexpr std::size_t first_update_row(std::size_t j, std::size_t w) {
    return 6 * j / w * w;
}
/// Number of scalars that block columns 0 to j - 1 do not store, divided by six: the sum of their
/// first_update_row.
constexpr std::size_t omitted_rows_before(std::size_t j, std::size_t w) {
    const std::size_t period = w / 2;  // block columns in three strips
    const std::size_t periods = j / period;
    std::size_t sum = 3 * w * period * (periods * (periods - 1) / 2);
    for (std::size_t i = 0; i < period; ++i) sum += periods * first_update_row(i, w);
    for (std::size_t i = period * periods; i < j; ++i) sum += first_update_row(i, w);
    return sum;
}
/// Offset at which row 0 of block column j would be if it were stored.
constexpr std::size_t update_column_offset(std::size_t j, std::size_t stride, std::size_t w) {
    return 6 * (j * stride - omitted_rows_before(j, w)) - first_update_row(j, w);
}
/// Number of scalars from one column to the next within block column j.
constexpr std::size_t update_column_stride(std::size_t j, std::size_t stride, std::size_t w) {
    return stride - first_update_row(j, w);
}

/// A submatrix of the matrix and its target in the panel of a front.
struct FrontEntry {
    std::uint32_t source = 0;  ///< index into BlockMatrix::upper
    bool transposed = false;   ///< the transpose of the source is added
    int row = 0;               ///< scalar row of the panel
    int column = 0;            ///< block column of the panel
};

/// The dense front of a supernode and its position in the work space. The panel holds the columns of its
/// pivots: the pivot rows, then the rows below them, each padded to whole strips. The update matrix is the
/// Schur complement contribution -L21 L21^T to the rows below; it is added to the panel and the update of
/// the parent.
struct Front {
    int first = 0;    ///< position of its first block in the elimination order
    int pivots = 0;   ///< number of blocks that it eliminates
    int rows = 0;     ///< number of block rows below the pivots
    int parent = -1;  ///< front; -1 for a root
    int pivot_strips = 0;
    int row_strips = 0;
    std::size_t row_begin = 0;         ///< into SymbolicFactor::rows and ::relative_indices
    std::size_t entry_begin = 0;       ///< into SymbolicFactor::entries
    std::size_t child_begin = 0;       ///< into SymbolicFactor::children
    std::size_t panel = 0;             ///< offset in the factor, scalars
    bool in_subtree = false;           ///< its update is in the space of the thread, not in the shared space
    std::size_t update = 0;            ///< offset of the update in that space, scalars
    std::size_t stride = 0;            ///< scalar rows of the update, padded to whole strips
    double cost = 0;                   ///< ns, predicted
    bool split_among_threads = false;  ///< its work is parallel, and it comes after all tasks
};

/// A subtree of the assembly tree, fronts [begin, end). One thread factorises it independently of the others.
struct Subtree {
    int begin = 0;
    int end = 0;
    double cost = 0;  ///< ns, predicted
};

/// The part of a factorisation that depends on the pattern alone: the fronts in elimination order, the
/// sources of their entries, and the layout of the work space.
struct SymbolicFactor {
    std::vector<int> order;             ///< order[k] is the block eliminated k-th
    std::vector<Front> fronts;          ///< and one more, whose *_begin are the ends of the last front
    std::vector<int> rows;              ///< by front, positions of the blocks below its pivots, ascending
    std::vector<int> relative_indices;  ///< per entry of `rows`, its index among the parent's pivots and rows
    std::vector<FrontEntry> entries;    ///< by front
    std::vector<int> children;          ///< by front
    std::vector<Subtree> subtrees;      ///< independent of each other, most expensive first
    /// Smaller subtrees, ascending. Each is refactorised as a whole or not at all.
    std::vector<Subtree> refactor_units;
    std::vector<int> top_fronts;    ///< the fronts above `subtrees`, ascending
    TaskForest tasks;               ///< the subtrees, then the fronts of `top_fronts`
    double cost = 0;                ///< ns, predicted
    std::size_t factor_size = 0;    ///< scalars
    bool keeps_updates = false;     ///< updates of unit roots and of fronts above them keep their own memory
    std::size_t subtree_space = 0;  ///< scalars per thread, for the updates inside one subtree
    std::size_t shared_space = 0;   ///< scalars, for all other updates

    std::size_t count() const { return fronts.size() - 1; }
    /// The fronts of one of `tasks`.
    Subtree fronts_of(std::size_t task) const {
        if (task < subtrees.size()) return subtrees[task];
        const int front = top_fronts[task - subtrees.size()];
        return {front, front + 1, fronts[front].cost};
    }
    std::span<const int> rows_of(std::size_t f) const {
        return std::span(rows).subspan(fronts[f].row_begin, fronts[f].rows);
    }
    std::span<const int> relative_indices_of(std::size_t f) const {
        return std::span(relative_indices).subspan(fronts[f].row_begin, fronts[f].rows);
    }
    /// How many of the rows of front `f`, which has a parent, are pivots of the parent: the first ones.
    int pivot_rows_of(std::size_t f) const {
        const std::span<const int> indices = relative_indices_of(f);
        return static_cast<int>(
            std::lower_bound(indices.begin(), indices.end(), fronts[fronts[f].parent].pivots) -
            indices.begin());
    }
    std::span<const int> children_of(std::size_t f) const {
        return std::span(children).subspan(fronts[f].child_begin,
                                           fronts[f + 1].child_begin - fronts[f].child_begin);
    }
    std::span<const FrontEntry> entries_of(std::size_t f) const {
        return {entries.data() + fronts[f].entry_begin, fronts[f + 1].entry_begin - fronts[f].entry_begin};
    }
};

/// Largest total size of updates, scalars, that is kept for refactorisation. Beyond it the memory is worth
/// more than the work saved.
inline constexpr std::size_t max_kept_updates = std::size_t{1} << 26;

/// @param rows_per_strip strip_rows of the factor's scalar. @param max_kept see max_kept_updates.
SymbolicFactor symbolic_factorization(const BlockPattern& pattern, const SupernodeTree& tree,
                                      int rows_per_strip, std::size_t max_kept = max_kept_updates);

}  // namespace rockslope::dda
