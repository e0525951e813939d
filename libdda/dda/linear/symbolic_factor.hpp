#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dda/linear/supernodes.hpp"
#include "dda/linear/task_forest.hpp"

namespace rockslope::dda {

/// Scalars in a strip: the rows of a front's panel are stored in strips of 64 bytes, see front_kernels.hpp.
template <class Scalar>
inline constexpr int strip_rows = 64 / static_cast<int>(sizeof(Scalar));

/// Scalars before a panel's strips: the factors of its 6x6 submatrices on the diagonal, in whole strips.
constexpr std::size_t diagonal_blocks_size(int pivots, std::size_t rows_per_strip) {
    return (static_cast<std::size_t>(pivots) * 36 + rows_per_strip - 1) / rows_per_strip * rows_per_strip;
}
template <class Scalar>
constexpr std::size_t diagonal_blocks_size(int pivots) {
    return diagonal_blocks_size(pivots, strip_rows<Scalar>);
}

/// An update is symmetric: of block column j only scalar rows from first_update_row on are kept, where the
/// strip begins that the diagonal enters.
/// @param w strip_rows
constexpr std::size_t first_update_row(std::size_t j, std::size_t w) {
    return 6 * j / w * w;
}
/// What columns before block column j leave out, over six: the sum of their first_update_row.
constexpr std::size_t omitted_rows_before(std::size_t j, std::size_t w) {
    const std::size_t period = w / 2;  // blocks in three strips
    const std::size_t periods = j / period;
    std::size_t sum = 3 * w * period * (periods * (periods - 1) / 2);
    for (std::size_t i = 0; i < period; ++i) sum += periods * first_update_row(i, w);
    for (std::size_t i = period * periods; i < j; ++i) sum += first_update_row(i, w);
    return sum;
}
/// Where row 0 of block column j would be if it were kept.
constexpr std::size_t update_column_offset(std::size_t j, std::size_t stride, std::size_t w) {
    return 6 * (j * stride - omitted_rows_before(j, w)) - first_update_row(j, w);
}
/// Scalars from a column of block column j to the next.
constexpr std::size_t update_column_stride(std::size_t j, std::size_t stride, std::size_t w) {
    return stride - first_update_row(j, w);
}

/// A submatrix of the step's matrix, where it goes in a front.
struct FrontEntry {
    int source = 0;           ///< index into BlockMatrix::upper; into ::diagonal for an entry on the diagonal
    bool transposed = false;  ///< it is the source's transpose
    int row = 0;              ///< scalar row of the panel
    int column = 0;           ///< block column of the panel
};

/// A supernode's place in the work space. Its panel holds the columns that it eliminates: its pivots' rows,
/// filled up to whole strips, then the rows that it reaches, likewise. Its update is what the elimination
/// takes from the rows that it reaches, added to its parent's panel and update.
struct Front {
    int first = 0;   ///< place of its first block in the order
    int pivots = 0;  ///< blocks that it eliminates
    int rows = 0;    ///< later blocks that it reaches
    int parent = -1;
    int pivot_strips = 0;
    int row_strips = 0;
    std::size_t row_begin = 0;    ///< into SymbolicFactor::rows and ::relative_indices
    std::size_t entry_begin = 0;  ///< into SymbolicFactor::entries
    std::size_t child_begin = 0;  ///< into SymbolicFactor::children
    std::size_t panel = 0;        ///< offset in the factor, scalars
    bool in_subtree = false;      ///< its update is in the space of the thread that works on the subtree
    std::size_t update = 0;       ///< offset in its space, scalars
    std::size_t stride = 0;       ///< scalar rows of its update, in whole strips
    double cost = 0;              ///< ns, predicted
    bool divided = false;         ///< threads divide its work, when all tasks are done
};

/// Fronts whose subtrees a thread can work through without asking others: fronts [begin, end).
struct Subtree {
    int begin = 0;
    int end = 0;
    double cost = 0;  ///< ns, predicted
};

/// Everything about a factorisation that depends on the pattern alone: fronts in the order of elimination,
/// where their entries come from, and where everything is kept.
struct SymbolicFactor {
    std::vector<int> order;             ///< order[k] is the block eliminated k-th
    std::vector<Front> fronts;          ///< one more than there are: the last one's *_begin are the ends
    std::vector<int> rows;              ///< of each front: places of the blocks that it reaches, ascending
    std::vector<int> relative_indices;  ///< beside `rows`: which pivot or row of the parent, counted through
    std::vector<FrontEntry> entries;    ///< by front
    std::vector<int> children;          ///< by front
    std::vector<Subtree> subtrees;      ///< independent of each other, the dearest first
    std::vector<Subtree>
        refactor_units;             ///< likewise, smaller: each is worked through as a whole or not at all
    std::vector<int> top_fronts;    ///< the fronts above them, ascending
    TaskForest tasks;               ///< the subtrees, then the fronts of `top_fronts`
    double cost = 0;                ///< ns, predicted
    std::size_t factor_size = 0;    ///< scalars
    bool keeps_updates = false;     ///< those of refactor_units' roots and above, each in a place of its own
    std::size_t subtree_space = 0;  ///< scalars, for the updates within any one subtree
    std::size_t shared_space = 0;   ///< scalars, for those of the subtrees' roots and above

    std::size_t count() const { return fronts.size() - 1; }
    Subtree fronts_of(std::size_t task) const {
        if (task < subtrees.size()) return subtrees[task];
        const int front = top_fronts[task - subtrees.size()];
        return {front, front + 1, fronts[static_cast<std::size_t>(front)].cost};
    }
    std::span<const int> rows_of(std::size_t f) const {
        return {rows.data() + fronts[f].row_begin, static_cast<std::size_t>(fronts[f].rows)};
    }
    std::span<const int> relative_indices_of(std::size_t f) const {
        return {relative_indices.data() + fronts[f].row_begin, static_cast<std::size_t>(fronts[f].rows)};
    }
    std::span<const int> children_of(std::size_t f) const {
        return {children.data() + fronts[f].child_begin, fronts[f + 1].child_begin - fronts[f].child_begin};
    }
    std::span<const FrontEntry> entries_of(std::size_t f) const {
        return {entries.data() + fronts[f].entry_begin, fronts[f + 1].entry_begin - fronts[f].entry_begin};
    }
};

/// Scalars of updates up to which they are all kept: beyond, memory is worth more than the work that they
/// save.
inline constexpr std::size_t max_kept_updates = std::size_t{1} << 26;

/// @param rows_per_strip strip_rows of the factor's scalar.
SymbolicFactor symbolic_factorization(const BlockPattern& pattern, const SupernodeTree& tree,
                                      int rows_per_strip, std::size_t max_kept = max_kept_updates);

}  // namespace rockslope::dda
