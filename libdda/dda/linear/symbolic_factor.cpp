#include "dda/linear/symbolic_factor.hpp"

#include <algorithm>
#include <numeric>

#include "dda/linear/elimination_tree.hpp"

namespace rockslope::dda {

namespace {

/// A subtree that costs more than this fraction of the factorisation is divided further. That gives enough
/// subtrees for two to four threads to finish at about the same time.
constexpr double max_subtree_fraction = 1.0 / 12;
/// Largest cost, ns, of a subtree that is refactorised as a whole when any row of it changes. Its inner
/// updates need not be kept, and stay in the cache.
constexpr double refactor_unit_cost = 7e4;
/// Smallest cost, ns, of a front whose dense work is split among threads. Each chunk then takes long compared
/// with its hand-over, and few other fronts could run beside it.
constexpr double min_split_cost = 5e5;

/// First-fit allocator of intervals of the work space.
class WorkspaceAllocator {
  public:
    std::size_t allocate(std::size_t size) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            Interval& gap = free_[i];
            if (gap.size < size) continue;
            const std::size_t at = gap.begin;
            gap.begin += size;
            gap.size -= size;
            if (gap.size == 0) free_.erase(std::next(free_.begin(), i));
            return at;
        }
        const bool last_is_free = !free_.empty() && free_.back().begin + free_.back().size == end_;
        const std::size_t at = last_is_free ? free_.back().begin : end_;
        if (last_is_free) free_.pop_back();
        end_ = at + size;
        return at;
    }
    void deallocate(std::size_t begin, std::size_t size) {
        if (size == 0) return;
        auto next =
            std::find_if(free_.begin(), free_.end(), [&](const Interval& gap) { return gap.begin > begin; });
        next = free_.insert(next, {begin, size});
        if (const auto after = next + 1; after != free_.end() && next->begin + next->size == after->begin) {
            next->size += after->size;
            free_.erase(after);
        }
        if (next != free_.begin()) {
            const auto before = next - 1;
            if (before->begin + before->size == next->begin) {
                before->size += next->size;
                free_.erase(next);
            }
        }
    }
    std::size_t end() const { return end_; }

  private:
    struct Interval {
        std::size_t begin = 0;
        std::size_t size = 0;
    };
    std::vector<Interval> free_;  ///< ascending
    std::size_t end_ = 0;
};

class SymbolicAnalysis {
  public:
    SymbolicAnalysis(const BlockPattern& pattern, const SupernodeTree& tree, int rows_per_strip,
                     std::size_t max_kept)
        : pattern_(pattern), tree_(tree), rows_per_strip_(rows_per_strip), max_kept_(max_kept) {
        symbolic_.order = tree.order;
    }

    SymbolicFactor run() {
        create_fronts();
        find_relative_indices();
        find_entries();
        partition_subtrees();
        allocate_updates();
        choose_split_fronts();
        return std::move(symbolic_);
    }

  private:
    std::size_t strips(std::size_t blocks) const {
        return (blocks * block_unknowns + rows_per_strip_ - 1) / rows_per_strip_;
    }

    void create_fronts() {
        std::vector<std::vector<int>> children(tree_.nodes.size());
        for (std::size_t f = 0; f < tree_.nodes.size(); ++f) {
            const int parent = tree_.nodes[f].parent;
            if (parent >= 0) children[parent].push_back(f);
        }
        for (std::size_t f = 0; f < tree_.nodes.size(); ++f) {
            const Supernode& node = tree_.nodes[f];
            Front front;
            front.first = node.first;
            front.pivots = node.pivots;
            front.rows = node.rows.size();
            front.parent = node.parent;
            front.pivot_strips = strips(front.pivots);
            front.row_strips = strips(front.rows);
            front.row_begin = symbolic_.rows.size();
            front.child_begin = symbolic_.children.size();
            front.panel = symbolic_.factor_size;
            front.stride = strips(front.rows) * rows_per_strip_;
            front.cost = front_cost(front.pivots, front.rows);
            symbolic_.factor_size += diagonal_blocks_size(front.pivots, rows_per_strip_);
            symbolic_.factor_size +=
                (strips(front.pivots) + strips(front.rows)) * rows_per_strip_ * front.pivots * block_unknowns;
            symbolic_.rows.insert(symbolic_.rows.end(), node.rows.begin(), node.rows.end());
            symbolic_.children.insert(symbolic_.children.end(), children[f].begin(), children[f].end());
            symbolic_.fronts.push_back(front);
        }
        Front end;
        end.row_begin = symbolic_.rows.size();
        end.child_begin = symbolic_.children.size();
        symbolic_.fronts.push_back(end);
    }

    /// Index of a position among the pivots and rows of a front.
    int index_in(std::size_t f, int position) const {
        const Front& front = symbolic_.fronts[f];
        if (position < front.first + front.pivots) return position - front.first;
        const auto rows = symbolic_.rows_of(f);
        return front.pivots +
               static_cast<int>(std::lower_bound(rows.begin(), rows.end(), position) - rows.begin());
    }

    void find_relative_indices() {
        symbolic_.relative_indices.reserve(symbolic_.rows.size());
        for (std::size_t f = 0; f < symbolic_.count(); ++f) {
            for (const int position : symbolic_.rows_of(f))
                symbolic_.relative_indices.push_back(index_in(symbolic_.fronts[f].parent, position));
        }
    }

    int scalar_row(const Front& front, int index) const {
        if (index < front.pivots) return index * block_unknowns;
        return front.pivot_strips * static_cast<int>(rows_per_strip_) +
               (index - front.pivots) * block_unknowns;
    }

    void find_entries() {
        const std::vector<int> position = inverse_permutation(symbolic_.order);
        std::vector<std::vector<FrontEntry>> by_column(symbolic_.order.size());
        std::vector<std::size_t> front_of(symbolic_.order.size());
        for (std::size_t f = 0; f < symbolic_.count(); ++f) {
            const Front& front = symbolic_.fronts[f];
            std::fill_n(front_of.begin() + front.first, front.pivots, f);
        }
        for (std::size_t i = 0; i < position.size(); ++i) {
            for (std::uint32_t k = pattern_.start[i]; k < pattern_.start[i + 1]; ++k) {
                const int a = position[i];
                const int b = position[pattern_.columns[k]];
                const int column = std::min(a, b);
                const Front& front = symbolic_.fronts[front_of[column]];
                by_column[column].push_back({k, a < b,
                                             scalar_row(front, index_in(front_of[column], std::max(a, b))),
                                             column - front.first});
            }
        }
        symbolic_.entries.reserve(pattern_.columns.size());
        for (std::size_t f = 0; f < symbolic_.count(); ++f) {
            Front& front = symbolic_.fronts[f];
            front.entry_begin = symbolic_.entries.size();
            for (int column = front.first; column < front.first + front.pivots; ++column) {
                const auto& entries = by_column[column];
                symbolic_.entries.insert(symbolic_.entries.end(), entries.begin(), entries.end());
            }
        }
        symbolic_.fronts.back().entry_begin = symbolic_.entries.size();
    }

    void partition_subtrees() {
        const std::size_t count = symbolic_.count();
        subtree_cost_.assign(count, 0);
        first_.resize(count);
        for (std::size_t f = 0; f < count; ++f) {
            symbolic_.cost += symbolic_.fronts[f].cost;
            subtree_cost_[f] += symbolic_.fronts[f].cost;
            first_[f] =
                symbolic_.children_of(f).empty() ? static_cast<int>(f) : first_[symbolic_.children_of(f)[0]];
            const int parent = symbolic_.fronts[f].parent;
            if (parent >= 0) subtree_cost_[parent] += subtree_cost_[f];
        }
        const double limit = symbolic_.cost * max_subtree_fraction;
        symbolic_.subtrees = subtrees_up_to(limit);
        symbolic_.refactor_units = subtrees_up_to(std::min(limit, refactor_unit_cost));
        for (std::size_t f = 0; f < count; ++f) {
            if (subtree_cost_[f] > limit) symbolic_.top_fronts.push_back(f);
        }
        std::stable_sort(symbolic_.subtrees.begin(), symbolic_.subtrees.end(),
                         [](const Subtree& a, const Subtree& b) { return a.cost > b.cost; });
        symbolic_.tasks = find_tasks();
    }

    TaskForest find_tasks() const {
        std::vector<int> task_of(symbolic_.count(), -1);  // per front, set for top fronts only
        for (std::size_t k = 0; k < symbolic_.top_fronts.size(); ++k)
            task_of[symbolic_.top_fronts[k]] = symbolic_.subtrees.size() + k;
        std::vector<int> parent;
        std::vector<double> cost;
        const auto add_task = [&](int front, double task_cost) {
            const int above = symbolic_.fronts[front].parent;
            parent.push_back(above < 0 ? -1 : task_of[above]);
            cost.push_back(task_cost);
        };
        for (const Subtree& subtree : symbolic_.subtrees) add_task(subtree.end - 1, subtree.cost);
        for (const int f : symbolic_.top_fronts) add_task(f, symbolic_.fronts[f].cost);
        return {parent, cost};
    }

    /// The maximal subtrees that cost no more than `limit` ns, ascending.
    std::vector<Subtree> subtrees_up_to(double limit) const {
        std::vector<Subtree> subtrees;
        for (std::size_t f = 0; f < symbolic_.count(); ++f) {
            const int parent = symbolic_.fronts[f].parent;
            if (subtree_cost_[f] <= limit && (parent < 0 || subtree_cost_[parent] > limit))
                subtrees.push_back({first_[f], static_cast<int>(f) + 1, subtree_cost_[f]});
        }
        return subtrees;
    }

    /// Allocates the front's update, then frees those of its children.
    void allocate_update(std::size_t f, WorkspaceAllocator& space) {
        Front& front = symbolic_.fronts[f];
        front.update = space.allocate(size_of_update(front));
        for (const int child : symbolic_.children_of(f)) {
            const Front& below = symbolic_.fronts[child];
            space.deallocate(below.update, size_of_update(below));
        }
    }

    void allocate_updates() {
        for (const Subtree& unit : symbolic_.refactor_units) allocate_within(unit);
        for (std::size_t f = 0; f < symbolic_.count(); ++f) {
            Front& front = symbolic_.fronts[f];
            if (front.in_subtree) continue;
            front.update = symbolic_.shared_space;
            symbolic_.shared_space += size_of_update(front);
        }
        symbolic_.keeps_updates = symbolic_.shared_space <= max_kept_;
        if (!symbolic_.keeps_updates) reuse_space();
    }

    /// All ancestors of a split front are split too. Without kept updates every top front is split, because
    /// fronts that reuse each other's memory must run one after the other.
    void choose_split_fronts() {
        for (const int f : symbolic_.top_fronts) {
            Front& front = symbolic_.fronts[f];
            front.split_among_threads =
                front.split_among_threads || !symbolic_.keeps_updates || front.cost > min_split_cost;
            if (front.parent >= 0 && front.split_among_threads)
                symbolic_.fronts[front.parent].split_among_threads = true;
        }
    }

    /// Allocates with reuse. A thread works on one subtree at a time and needs one space for all of them. The
    /// updates of all subtree roots exist at the same time when the first top front begins.
    void reuse_space() {
        WorkspaceAllocator shared;
        for (const Subtree& subtree : symbolic_.subtrees) {
            allocate_within(subtree);
            Front& root = symbolic_.fronts[subtree.end - 1];
            root.update = shared.allocate(size_of_update(root));
        }
        for (const int f : symbolic_.top_fronts) allocate_update(f, shared);
        symbolic_.shared_space = shared.end();
    }

    /// Allocates the updates of all fronts of the subtree but its root.
    void allocate_within(const Subtree& subtree) {
        WorkspaceAllocator space;
        for (int f = subtree.begin; f + 1 < subtree.end; ++f) {
            symbolic_.fronts[f].in_subtree = true;
            allocate_update(f, space);
        }
        symbolic_.subtree_space = std::max(symbolic_.subtree_space, space.end());
    }

    std::size_t size_of_update(const Front& front) const {
        const std::size_t rows = front.rows;
        return block_unknowns * (rows * front.stride - omitted_rows_before(rows, rows_per_strip_));
    }

    const BlockPattern& pattern_;
    const SupernodeTree& tree_;
    std::size_t rows_per_strip_;
    std::size_t max_kept_;
    SymbolicFactor symbolic_;
    std::vector<double> subtree_cost_;  ///< per front, cost of its subtree, ns
    std::vector<int> first_;            ///< per front, the first front of its subtree
};

}  // namespace

SymbolicFactor symbolic_factorization(const BlockPattern& pattern, const SupernodeTree& tree,
                                      int rows_per_strip, std::size_t max_kept) {
    return SymbolicAnalysis(pattern, tree, rows_per_strip, max_kept).run();
}

}  // namespace rockslope::dda
