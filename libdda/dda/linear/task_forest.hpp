#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope::dda {

/// A forest of tasks, run leaves first or roots first. A task starts when its children, or its parent, have
/// ended. A free thread takes the ready task with the longest critical path.
class TaskForest {
  public:
    /// Executes one task on one thread; threads are numbered from zero. It must not throw.
    using Body = std::function<void(std::size_t task, std::size_t thread)>;

    TaskForest() = default;
    /// @param parent per task, its index is greater than the task's; -1 for a root.
    /// @param cost per task, in any unit.
    TaskForest(const std::vector<int>& parent, const std::vector<double>& cost);

    /// Number of tasks.
    std::size_t count() const { return up_.critical_path.size(); }
    /// Calls body(task, thread) once for each task, after its children.
    void run_leaves_first(const ThreadPool& pool, const Body& body) const;
    /// Calls body(task, thread) once for each task, after its parent.
    void run_roots_first(const ThreadPool& pool, const Body& body) const;

  private:
    struct Direction {
        std::vector<std::vector<int>> dependents;  ///< per task, the tasks that wait for it
        std::vector<int> dependency_count;         ///< per task, how many tasks it waits for
        std::vector<double> critical_path;         ///< per task, largest cost of a path from it to the end
    };
    static void run(const Direction& direction, const ThreadPool& pool, const Body& body);

    Direction up_;    ///< leaves first
    Direction down_;  ///< roots first
};

}  // namespace rockslope::dda
