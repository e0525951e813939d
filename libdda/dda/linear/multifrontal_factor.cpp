#include "dda/linear/multifrontal_factor.hpp"

#include <algorithm>
#include <atomic>
#include <functional>

#include "dda/linear/front_kernels.hpp"

namespace rockslope::dda {

namespace {

/// Adds a 6x6 submatrix to the strips of a panel. @param source source(r, c) is its entry.
template <class Scalar, class Source>
void add_to_strips(Scalar* strips, int row, int block_column, int columns, const Source& source) {
    constexpr int w = strip_rows<Scalar>;
    for (int r = 0; r < block_unknowns;) {
        const int in_strip = (row + r) % w;
        const int count = std::min(block_unknowns - r, w - in_strip);
        Scalar* at = strips + static_cast<std::ptrdiff_t>((row + r) / w) * w * columns +
                     static_cast<std::ptrdiff_t>(block_column) * block_unknowns * w + in_strip;
        for (int c = 0; c < block_unknowns; ++c, at += w) {
            for (int k = 0; k < count; ++k) at[k] += source(r + k, c);
        }
        r += count;
    }
}

/// Smallest predicted work, ns, that is split among threads. A hand-over to another thread takes about 10 us.
constexpr double min_parallel_cost = 1e5;

/// Calls body(begin, end) for chunks of [0, count), in parallel if the work takes at least min_parallel_cost.
/// @param cost ns, predicted.
template <class Body>
void parallel_for_chunks(const ThreadPool& pool, double cost, int count, const Body& body) {
    if (pool.size() == 1 || cost < min_parallel_cost) {
        if (count > 0) body(0, count);
        return;
    }
    const int chunk = std::clamp(count / (4 * pool.size()), 1, 8);
    const auto run_chunk = [&](std::size_t k, std::size_t) {
        const int begin = static_cast<int>(k) * chunk;
        body(begin, std::min(begin + chunk, count));
    };
    pool.parallel_for_dynamic((count + chunk - 1) / chunk, std::ref(run_chunk));
}

}  // namespace

template <class Scalar>
void MultifrontalFactor<Scalar>::analyze(const BlockPattern& pattern, const SupernodeTree& tree,
                                         std::size_t max_kept) {
    symbolic_ = symbolic_factorization(pattern, tree, strip_rows<Scalar>, max_kept);
    has_factor_ = false;
    factor_.resize(symbolic_.factor_size);
    vector_begin_.clear();
    std::size_t end = 0;
    for (const Front& front : symbolic_.fronts) {
        vector_begin_.push_back(end);
        end += std::size_t{strip_rows<Scalar>} * (front.pivot_strips + front.row_strips);
    }
    vectors_.resize(end);
}

template <class Scalar>
void MultifrontalFactor<Scalar>::assemble_panel(const BlockMatrix& matrix, std::size_t f,
                                                const ThreadPool& pool) {
    const Front& front = symbolic_.fronts[f];
    const int columns = front.pivots * block_unknowns;
    Scalar* strips = panel(front) + diagonal_blocks_size<Scalar>(front.pivots);
    const auto set_strips_to_zero = [&](int begin, int end) {
        const std::ptrdiff_t strip_size = std::ptrdiff_t{strip_rows<Scalar>} * columns;
        std::fill(strips + begin * strip_size, strips + end * strip_size, Scalar(0));
    };
    parallel_for_chunks(pool, front.cost, front.pivot_strips + front.row_strips, set_strips_to_zero);
    for (int k = 0; k < front.pivots; ++k) {
        const int column = front.first + k;
        const int block = symbolic_.order[column];
        const Mat6& diagonal = matrix.diagonal[block];
        add_to_strips(strips, k * block_unknowns, k, columns,
                      [&](int r, int c) { return static_cast<Scalar>(diagonal(r, c)); });
    }
    for (const FrontEntry& entry : symbolic_.entries_of(f)) {
        const Mat6& upper = matrix.upper[entry.source];
        if (entry.transposed)
            add_to_strips(strips, entry.row, entry.column, columns,
                          [&](int r, int c) { return static_cast<Scalar>(upper(c, r)); });
        else
            add_to_strips(strips, entry.row, entry.column, columns,
                          [&](int r, int c) { return static_cast<Scalar>(upper(r, c)); });
    }
}

template <class Scalar>
void MultifrontalFactor<Scalar>::add_column_to_panel(const Front& front, int c, std::size_t j,
                                                     Scalar* space) {
    constexpr std::size_t w = strip_rows<Scalar>;
    const Front& child = symbolic_.fronts[c];
    const std::span<const int> relative_indices = symbolic_.relative_indices_of(c);
    Scalar* strips = panel(front) + diagonal_blocks_size<Scalar>(front.pivots);
    const Scalar* column = update(child, space) + update_column_offset(j, child.stride, w);
    const std::size_t stride = update_column_stride(j, child.stride, w);
    for (std::size_t i = j; i < relative_indices.size(); ++i) {
        const int row = relative_indices[i] < front.pivots
                            ? relative_indices[i] * block_unknowns
                            : front.pivot_strips * strip_rows<Scalar> +
                                  (relative_indices[i] - front.pivots) * block_unknowns;
        const Scalar* source = column + i * block_unknowns;
        add_to_strips(strips, row, relative_indices[j], front.pivots * block_unknowns,
                      [&](int r, int q) { return source[q * stride + r]; });
    }
}

template <class Scalar>
void MultifrontalFactor<Scalar>::add_column_to_update(const Front& front, int c, std::size_t j,
                                                      Scalar* space) {
    constexpr std::size_t w = strip_rows<Scalar>;
    const Front& child = symbolic_.fronts[c];
    const std::span<const int> relative_indices = symbolic_.relative_indices_of(c);
    const std::size_t column = relative_indices[j] - front.pivots;
    const Scalar* from = update(child, space) + update_column_offset(j, child.stride, w);
    Scalar* to = update(front, space) + update_column_offset(column, front.stride, w);
    const std::size_t from_stride = update_column_stride(j, child.stride, w);
    const std::size_t to_stride = update_column_stride(column, front.stride, w);
    for (std::size_t i = j; i < relative_indices.size();) {  // runs of rows contiguous in both
        std::size_t end = i + 1;
        while (end < relative_indices.size() && relative_indices[end] == relative_indices[end - 1] + 1) ++end;
        const Scalar* source = from + i * block_unknowns;
        Scalar* target = to + (relative_indices[i] - front.pivots) * block_unknowns;
        const std::size_t count = (end - i) * block_unknowns;
        for (int q = 0; q < block_unknowns; ++q, source += from_stride, target += to_stride) {
            for (std::size_t k = 0; k < count; ++k) target[k] += source[k];
        }
        i = end;
    }
}

template <class Scalar>
void MultifrontalFactor<Scalar>::add_updates_to_panel(std::size_t f, Scalar* space, const ThreadPool& pool) {
    const Front& front = symbolic_.fronts[f];
    for (const int c : symbolic_.children_of(f))
        parallel_for_chunks(pool, front.cost, symbolic_.pivot_rows_of(c), [&](int begin, int end) {
            for (int j = begin; j < end; ++j) add_column_to_panel(front, c, j, space);
        });
}

template <class Scalar>
void MultifrontalFactor<Scalar>::add_updates_to_update(std::size_t f, Scalar* space, const ThreadPool& pool) {
    const Front& front = symbolic_.fronts[f];
    for (const int c : symbolic_.children_of(f)) {
        const int first = symbolic_.pivot_rows_of(c);
        parallel_for_chunks(pool, front.cost, symbolic_.fronts[c].rows - first, [&](int begin, int end) {
            for (int j = first + begin; j < first + end; ++j) add_column_to_update(front, c, j, space);
        });
    }
}

template <class Scalar>
bool MultifrontalFactor<Scalar>::factor_pivots(const Front& front, const ThreadPool& pool) {
    constexpr int group = 8;  // block columns; the rows below them are shared
    const int step = pool.size() == 1 || front.cost < min_parallel_cost ? front.pivots : group;
    for (int begin = 0; begin < front.pivots; begin += step) {
        const int end = std::min(begin + step, front.pivots);
        if (!kernels_.factor_pivots(panel(front), front.pivots, begin, end)) return false;
        const int done = (end * block_unknowns + strip_rows<Scalar> - 1) / strip_rows<Scalar>;
        const auto solve_strips = [&](int first_strip, int end_strip) {
            kernels_.solve_pivot_rows(panel(front), front.pivots, begin, end, done + first_strip,
                                      done + end_strip);
        };
        parallel_for_chunks(pool, front.cost, front.pivot_strips - done, solve_strips);
    }
    return true;
}

template <class Scalar>
bool MultifrontalFactor<Scalar>::eliminate(std::size_t f, Scalar* space, const ThreadPool& pool) {
    const Front& front = symbolic_.fronts[f];
    if (!factor_pivots(front, pool)) return false;
    const auto solve_strips = [&](int begin, int end) {
        kernels_.solve_rows(panel(front), front.pivots, begin, end);
    };
    const auto form_update_columns = [&](int begin, int end) {
        kernels_.form_update(panel(front), front.pivots, front.row_strips,
                             {update(front, space), static_cast<long>(front.stride)}, begin, end);
    };
    parallel_for_chunks(pool, front.cost, front.row_strips, solve_strips);
    kernels_.invert_groups(panel(front), front.pivots);
    parallel_for_chunks(pool, front.cost, front.rows, form_update_columns);
    return true;
}

template <class Scalar>
bool MultifrontalFactor<Scalar>::factorize_front(std::size_t f, const BlockMatrix& matrix, Scalar* space,
                                                 const ThreadPool& pool) {
    assemble_panel(matrix, f, pool);
    add_updates_to_panel(f, space, pool);
    if (!eliminate(f, space, pool)) return false;
    add_updates_to_update(f, space, pool);
    return true;
}

template <class Scalar>
void MultifrontalFactor<Scalar>::find_outdated(std::span<const char> changed) {
    const bool all = changed.empty() || !has_factor_ || !symbolic_.keeps_updates;
    outdated_.assign(symbolic_.count(), all ? 1 : 0);
    if (all) return;
    for (std::size_t f = 0; f < symbolic_.count(); ++f) {
        const Front& front = symbolic_.fronts[f];
        for (int k = front.first; k < front.first + front.pivots; ++k) {
            const int row = symbolic_.order[k];
            if (changed[row] != 0) outdated_[f] = 1;
        }
        if (outdated_[f] != 0 && front.parent >= 0) outdated_[front.parent] = 1;
    }
    for (const Subtree& unit : symbolic_.refactor_units) {
        if (outdated_[unit.end - 1] != 0)
            std::fill(outdated_.begin() + unit.begin, outdated_.begin() + unit.end, 1);
    }
}

template <class Scalar>
bool MultifrontalFactor<Scalar>::factorize(const BlockMatrix& matrix, const ThreadPool& pool,
                                           std::span<const char> changed) {
    const ThreadPool serial(1);
    find_outdated(changed);
    shared_updates_.resize(symbolic_.shared_space);
    subtree_updates_.resize(symbolic_.subtree_space * pool.size());
    std::atomic<bool> definite{true};
    const auto factorize_fronts = [&](const Subtree& fronts, Scalar* space, const ThreadPool& helpers) {
        for (int f = fronts.begin; f < fronts.end && definite; ++f) {
            if (outdated_[f] != 0 && !factorize_front(f, matrix, space, helpers)) definite = false;
        }
    };
    const auto is_split = [&](const Subtree& fronts) {
        return symbolic_.fronts[fronts.begin].split_among_threads;
    };
    symbolic_.tasks.run_leaves_first(
        symbolic_.cost < min_parallel_cost ? serial : pool, [&](std::size_t task, std::size_t thread) {
            const Subtree fronts = symbolic_.fronts_of(task);
            Scalar* space = subtree_updates_.data() + thread * symbolic_.subtree_space;
            if (!is_split(fronts)) factorize_fronts(fronts, space, serial);
        });
    for (std::size_t task = symbolic_.subtrees.size(); task < symbolic_.tasks.count(); ++task) {
        const Subtree fronts = symbolic_.fronts_of(task);
        if (is_split(fronts)) factorize_fronts(fronts, nullptr, pool);
    }
    if (!symbolic_.keeps_updates) {
        shared_updates_.release();
        subtree_updates_.release();
    }
    has_factor_ = definite;
    return definite;
}

template <class Scalar>
void MultifrontalFactor<Scalar>::solve_forward(std::size_t f, std::span<const Vec6> b) {
    const Front& front = symbolic_.fronts[f];
    const int padded = front.pivot_strips * strip_rows<Scalar>;
    Scalar* x = vector(f);
    for (int k = 0; k < front.pivots; ++k) block(x, k) = b[row_of_pivot(front, k)].template cast<Scalar>();
    Scalar* rows = x + padded;
    std::fill(x + front.pivots * block_unknowns, rows + front.row_strips * strip_rows<Scalar>, Scalar(0));
    for (const int c : symbolic_.children_of(f)) {
        const Scalar* from = vector(c) + symbolic_.fronts[c].pivot_strips * strip_rows<Scalar>;
        for (const int target : symbolic_.relative_indices_of(c)) {
            Scalar* to = target < front.pivots ? x + target * block_unknowns
                                               : rows + (target - front.pivots) * block_unknowns;
            for (int q = 0; q < block_unknowns; ++q) to[q] += from[q];
            from += block_unknowns;
        }
    }
    kernels_.forward(panel(front), front.pivots, front.pivot_strips + front.row_strips, x);
}

template <class Scalar>
void MultifrontalFactor<Scalar>::solve_backward(std::size_t f, std::span<Vec6> solution) {
    const Front& front = symbolic_.fronts[f];
    Scalar* x = vector(f);
    if (front.parent >= 0) {
        const Front& parent = symbolic_.fronts[front.parent];
        const Scalar* pivots = vector(front.parent);
        const Scalar* rows = pivots + parent.pivot_strips * strip_rows<Scalar>;
        Scalar* to = x + front.pivot_strips * strip_rows<Scalar>;
        for (const int target : symbolic_.relative_indices_of(f)) {
            std::copy_n(target < parent.pivots ? pivots + target * block_unknowns
                                               : rows + (target - parent.pivots) * block_unknowns,
                        block_unknowns, to);
            to += block_unknowns;
        }
    }
    kernels_.backward(panel(front), front.pivots, front.pivot_strips + front.row_strips, x);
    for (int k = 0; k < front.pivots; ++k)
        solution[row_of_pivot(front, k)] = block(x, k).template cast<double>();
}

template <class Scalar>
void MultifrontalFactor<Scalar>::solve(std::span<Vec6> x, const ThreadPool& pool) {
    const ThreadPool serial(1);
    const ThreadPool& helpers = symbolic_.factor_size < min_parallel_factor_size ? serial : pool;
    symbolic_.tasks.run_leaves_first(helpers, [&](std::size_t task, std::size_t) {
        const Subtree fronts = symbolic_.fronts_of(task);
        for (int f = fronts.begin; f < fronts.end; ++f) solve_forward(f, x);
    });
    symbolic_.tasks.run_roots_first(helpers, [&](std::size_t task, std::size_t) {
        const Subtree fronts = symbolic_.fronts_of(task);
        for (int f = fronts.end; f-- > fronts.begin;) solve_backward(f, x);
    });
}

template class MultifrontalFactor<float>;
template class MultifrontalFactor<double>;

}  // namespace rockslope::dda
