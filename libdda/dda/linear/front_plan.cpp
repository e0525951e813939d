#include "dda/linear/front_plan.hpp"

#include <algorithm>
#include <numeric>

#include "dda/linear/elimination_tree.hpp"

namespace dda {

namespace {

constexpr int unknowns = 6;
/// Subtrees above this share of the whole cost are divided further: enough of them for two to four threads to
/// end together, whatever their number is.
constexpr double largest_share = 1.0 / 12;
/// ns up to which a subtree is worked through as a whole where anything in it has changed: its inner updates
/// then need not be kept, and stay in the cache.
constexpr double unit_cost = 7e4;
/// ns from which on the work of a front is divided among threads: each portion is long beside its hand-over,
/// and there are few fronts beside it.
constexpr double least_divided_cost = 5e5;

/// Hands out intervals of the work space, first fit, and takes them back.
class Space {
  public:
    std::size_t take(std::size_t size) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            Interval& gap = free_[i];
            if (gap.size < size) continue;
            const std::size_t at = gap.begin;
            gap.begin += size;
            gap.size -= size;
            if (gap.size == 0) free_.erase(free_.begin() + static_cast<long>(i));
            return at;
        }
        const bool last_is_free = !free_.empty() && free_.back().begin + free_.back().size == end_;
        const std::size_t at = last_is_free ? free_.back().begin : end_;
        if (last_is_free) free_.pop_back();
        end_ = at + size;
        return at;
    }
    void give_back(std::size_t begin, std::size_t size) {
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

class Planner {
  public:
    Planner(const BlockPattern& pattern, const SupernodeTree& tree, int rows_per_strip, std::size_t most_kept)
        : pattern_(pattern),
          tree_(tree),
          rows_per_strip_(static_cast<std::size_t>(rows_per_strip)),
          most_kept_(most_kept) {
        plan_.order = tree.order;
    }

    FrontPlan plan() {
        lay_out_fronts();
        find_targets();
        find_entries();
        divide();
        place_updates();
        choose_divided();
        return std::move(plan_);
    }

  private:
    std::size_t strips(int blocks) const {
        return (static_cast<std::size_t>(blocks) * unknowns + rows_per_strip_ - 1) / rows_per_strip_;
    }

    void lay_out_fronts() {
        std::vector<std::vector<int>> children(tree_.nodes.size());
        for (std::size_t f = 0; f < tree_.nodes.size(); ++f) {
            const int parent = tree_.nodes[f].parent;
            if (parent >= 0) children[static_cast<std::size_t>(parent)].push_back(static_cast<int>(f));
        }
        for (std::size_t f = 0; f < tree_.nodes.size(); ++f) {
            const Supernode& node = tree_.nodes[f];
            Front front;
            front.first = node.first;
            front.pivots = node.pivots;
            front.rows = static_cast<int>(node.rows.size());
            front.parent = node.parent;
            front.pivot_strips = static_cast<int>(strips(front.pivots));
            front.row_strips = static_cast<int>(strips(front.rows));
            front.row_begin = plan_.rows.size();
            front.child_begin = plan_.children.size();
            front.panel = plan_.factor_size;
            front.stride = strips(front.rows) * rows_per_strip_;
            front.cost = front_cost(front.pivots, front.rows);
            plan_.factor_size += squares_size(front.pivots, rows_per_strip_);
            plan_.factor_size += (strips(front.pivots) + strips(front.rows)) * rows_per_strip_ *
                                 static_cast<std::size_t>(front.pivots) * unknowns;
            plan_.rows.insert(plan_.rows.end(), node.rows.begin(), node.rows.end());
            plan_.children.insert(plan_.children.end(), children[f].begin(), children[f].end());
            plan_.fronts.push_back(front);
        }
        Front end;
        end.row_begin = plan_.rows.size();
        end.child_begin = plan_.children.size();
        plan_.fronts.push_back(end);
    }

    /// The pivot of a front, or the row behind them, that a place is.
    int index_in(std::size_t f, int place) const {
        const Front& front = plan_.fronts[f];
        if (place < front.first + front.pivots) return place - front.first;
        const auto rows = plan_.rows_of(f);
        return front.pivots +
               static_cast<int>(std::lower_bound(rows.begin(), rows.end(), place) - rows.begin());
    }

    void find_targets() {
        plan_.targets.reserve(plan_.rows.size());
        for (std::size_t f = 0; f < plan_.count(); ++f) {
            for (const int place : plan_.rows_of(f))
                plan_.targets.push_back(index_in(static_cast<std::size_t>(plan_.fronts[f].parent), place));
        }
    }

    int scalar_row(const Front& front, int index) const {
        if (index < front.pivots) return index * unknowns;
        return front.pivot_strips * static_cast<int>(rows_per_strip_) + (index - front.pivots) * unknowns;
    }

    void find_entries() {
        const std::vector<int> place = places_in(plan_.order);
        std::vector<std::vector<FrontEntry>> by_column(plan_.order.size());
        std::vector<std::size_t> front_of(plan_.order.size());
        for (std::size_t f = 0; f < plan_.count(); ++f) {
            const Front& front = plan_.fronts[f];
            std::fill_n(front_of.begin() + front.first, front.pivots, f);
        }
        for (std::size_t i = 0; i < place.size(); ++i) {
            for (int k = pattern_.start[i]; k < pattern_.start[i + 1]; ++k) {
                const int a = place[i];
                const int b = place[static_cast<std::size_t>(pattern_.columns[static_cast<std::size_t>(k)])];
                const auto column = static_cast<std::size_t>(std::min(a, b));
                const Front& front = plan_.fronts[front_of[column]];
                by_column[column].push_back({k, a < b,
                                             scalar_row(front, index_in(front_of[column], std::max(a, b))),
                                             static_cast<int>(column) - front.first});
            }
        }
        plan_.entries.reserve(pattern_.columns.size());
        for (std::size_t f = 0; f < plan_.count(); ++f) {
            Front& front = plan_.fronts[f];
            front.entry_begin = plan_.entries.size();
            for (int column = front.first; column < front.first + front.pivots; ++column) {
                const auto& entries = by_column[static_cast<std::size_t>(column)];
                plan_.entries.insert(plan_.entries.end(), entries.begin(), entries.end());
            }
        }
        plan_.fronts.back().entry_begin = plan_.entries.size();
    }

    void divide() {
        const std::size_t count = plan_.count();
        subtree_cost_.assign(count, 0);
        first_.resize(count);
        for (std::size_t f = 0; f < count; ++f) {
            plan_.cost += plan_.fronts[f].cost;
            subtree_cost_[f] += plan_.fronts[f].cost;
            first_[f] = plan_.children_of(f).empty()
                            ? static_cast<int>(f)
                            : first_[static_cast<std::size_t>(plan_.children_of(f)[0])];
            const int parent = plan_.fronts[f].parent;
            if (parent >= 0) subtree_cost_[static_cast<std::size_t>(parent)] += subtree_cost_[f];
        }
        const double limit = plan_.cost * largest_share;
        plan_.subtrees = subtrees_up_to(limit);
        plan_.units = subtrees_up_to(std::min(limit, unit_cost));
        for (std::size_t f = 0; f < count; ++f) {
            if (subtree_cost_[f] > limit) plan_.top.push_back(static_cast<int>(f));
        }
        std::stable_sort(plan_.subtrees.begin(), plan_.subtrees.end(),
                         [](const Subtree& a, const Subtree& b) { return a.cost > b.cost; });
        plan_.tasks = find_tasks();
    }

    TaskForest find_tasks() const {
        std::vector<int> task_of(plan_.count(), -1);  // of the fronts of `top`
        for (std::size_t k = 0; k < plan_.top.size(); ++k)
            task_of[static_cast<std::size_t>(plan_.top[k])] = static_cast<int>(plan_.subtrees.size() + k);
        std::vector<int> parent;
        std::vector<double> cost;
        const auto add = [&](int front, double its_cost) {
            const int above = plan_.fronts[static_cast<std::size_t>(front)].parent;
            parent.push_back(above < 0 ? -1 : task_of[static_cast<std::size_t>(above)]);
            cost.push_back(its_cost);
        };
        for (const Subtree& subtree : plan_.subtrees) add(subtree.end - 1, subtree.cost);
        for (const int f : plan_.top) add(f, plan_.fronts[static_cast<std::size_t>(f)].cost);
        return {parent, cost};
    }

    /// The largest subtrees that cost no more, ascending.
    std::vector<Subtree> subtrees_up_to(double limit) const {
        std::vector<Subtree> subtrees;
        for (std::size_t f = 0; f < plan_.count(); ++f) {
            const int parent = plan_.fronts[f].parent;
            if (subtree_cost_[f] <= limit &&
                (parent < 0 || subtree_cost_[static_cast<std::size_t>(parent)] > limit))
                subtrees.push_back({first_[f], static_cast<int>(f) + 1, subtree_cost_[f]});
        }
        return subtrees;
    }

    /// Takes a place for the front's update, then gives back its children's.
    void place_update(std::size_t f, Space& space) {
        Front& front = plan_.fronts[f];
        front.update = space.take(size_of_update(front));
        for (const int child : plan_.children_of(f)) {
            const Front& below = plan_.fronts[static_cast<std::size_t>(child)];
            space.give_back(below.update, size_of_update(below));
        }
    }

    void place_updates() {
        for (const Subtree& unit : plan_.units) place_within(unit);
        for (std::size_t f = 0; f < plan_.count(); ++f) {
            Front& front = plan_.fronts[f];
            if (front.in_subtree) continue;
            front.update = plan_.shared_space;
            plan_.shared_space += size_of_update(front);
        }
        plan_.keeps_updates = plan_.shared_space <= most_kept_;
        if (!plan_.keeps_updates) share_space();
    }

    /// Fronts above such a front are, too. Where space for updates is shared each has to wait for the last.
    void choose_divided() {
        for (const int f : plan_.top) {
            Front& front = plan_.fronts[static_cast<std::size_t>(f)];
            front.divided = front.divided || !plan_.keeps_updates || front.cost > least_divided_cost;
            if (front.parent >= 0 && front.divided)
                plan_.fronts[static_cast<std::size_t>(front.parent)].divided = true;
        }
    }

    /// A thread works on one subtree at a time and needs one space for all. The updates of their roots are
    /// there together when the fronts above begin.
    void share_space() {
        Space shared;
        for (const Subtree& subtree : plan_.subtrees) {
            place_within(subtree);
            Front& root = plan_.fronts[static_cast<std::size_t>(subtree.end - 1)];
            root.update = shared.take(size_of_update(root));
        }
        for (const int f : plan_.top) place_update(static_cast<std::size_t>(f), shared);
        plan_.shared_space = shared.end();
    }

    /// Places the updates of all fronts but the root.
    void place_within(const Subtree& subtree) {
        Space space;
        for (int f = subtree.begin; f + 1 < subtree.end; ++f) {
            plan_.fronts[static_cast<std::size_t>(f)].in_subtree = true;
            place_update(static_cast<std::size_t>(f), space);
        }
        plan_.subtree_space = std::max(plan_.subtree_space, space.end());
    }

    std::size_t size_of_update(const Front& front) const {
        const auto rows = static_cast<std::size_t>(front.rows);
        return unknowns * (rows * front.stride - left_out_before(rows, rows_per_strip_));
    }

    const BlockPattern& pattern_;
    const SupernodeTree& tree_;
    std::size_t rows_per_strip_;
    std::size_t most_kept_;
    FrontPlan plan_;
    std::vector<double> subtree_cost_;  ///< per front, of its subtree, ns
    std::vector<int> first_;            ///< per front, the first of its subtree
};

}  // namespace

FrontPlan plan_fronts(const BlockPattern& pattern, const SupernodeTree& tree, int rows_per_strip,
                      std::size_t most_kept) {
    return Planner(pattern, tree, rows_per_strip, most_kept).plan();
}

}  // namespace dda
