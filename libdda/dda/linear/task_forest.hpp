#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope::dda {

/// Tasks of which each waits for others: its children in the one direction, its parent in the other. Whoever
/// of a pool is free takes, of those that need not wait any more, the one that heads the longest
/// critical_path.
class TaskForest {
  public:
    /// Does a task in a thread, which counts from zero. It throws nothing.
    using Body = std::function<void(std::size_t task, std::size_t thread)>;

    TaskForest() = default;
    /// @param parent per task, a later one, -1 for a root; @param cost per task, in any unit.
    TaskForest(const std::vector<int>& parent, const std::vector<double>& cost);

    std::size_t count() const { return up_.critical_path.size(); }
    /// Calls body(task, thread) for each task, for its children before.
    void run_leaves_first(const ThreadPool& pool, const Body& body) const;
    /// Likewise, for its parent before.
    void run_roots_first(const ThreadPool& pool, const Body& body) const;

  private:
    /// One of the two directions.
    struct Direction {
        std::vector<std::vector<int>> dependents;  ///< per task, those that wait for it
        std::vector<int> dependency_count;         ///< per task, how many
        std::vector<double> critical_path;         ///< per task, the cost from it to the end
    };
    static void run(const Direction& direction, const ThreadPool& pool, const Body& body);

    Direction up_;
    Direction down_;
};

}  // namespace rockslope::dda
