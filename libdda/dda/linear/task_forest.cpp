#include "dda/linear/task_forest.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace rockslope::dda {

namespace {

/// Priority queue of the tasks that wait for nothing, longest critical path first. Thread-safe.
class ReadyQueue {
  public:
    ReadyQueue(const std::vector<double>& critical_path, std::vector<int> dependency_count)
        : critical_path_(critical_path),
          dependency_count_(std::move(dependency_count)),
          not_started_(dependency_count_.size()) {
        for (std::size_t task = 0; task < dependency_count_.size(); ++task) {
            if (dependency_count_[task] == 0) push(static_cast<int>(task));
        }
    }
    bool all_started() const { return not_started_ == 0; }
    std::optional<std::size_t> pop() {
        const std::lock_guard lock(mutex_);
        if (ready_.empty()) return std::nullopt;
        std::pop_heap(ready_.begin(), ready_.end());
        const int task = ready_.back().second;
        ready_.pop_back();
        --not_started_;
        return task;
    }
    /// Counts down one dependency of each of these tasks, and queues those that have none left.
    void release(const std::vector<int>& tasks) {
        const std::lock_guard lock(mutex_);
        for (const int task : tasks) {
            if (--dependency_count_[task] == 0) push(task);
        }
    }

  private:
    void push(int task) {
        ready_.emplace_back(critical_path_[task], task);
        std::push_heap(ready_.begin(), ready_.end());
    }

    const std::vector<double>& critical_path_;
    std::mutex mutex_;
    std::vector<int> dependency_count_;
    std::vector<std::pair<double, int>> ready_;
    std::atomic<std::size_t> not_started_;
};

}  // namespace

TaskForest::TaskForest(const std::vector<int>& parent, const std::vector<double>& cost) {
    const std::size_t count = parent.size();
    up_ = {std::vector<std::vector<int>>(count), std::vector<int>(count, 0), cost};
    down_ = up_;
    std::vector<double> longest_below(count, 0);
    for (std::size_t task = 0; task < count; ++task) {
        down_.critical_path[task] += longest_below[task];
        if (parent[task] < 0) continue;
        const std::size_t above = parent[task];
        assert(task < above);
        up_.dependents[task].push_back(parent[task]);
        ++up_.dependency_count[above];
        down_.dependents[above].push_back(task);
        down_.dependency_count[task] = 1;
        longest_below[above] = std::max(longest_below[above], down_.critical_path[task]);
    }
    for (std::size_t task = count; task-- > 0;) {
        if (parent[task] >= 0) up_.critical_path[task] += up_.critical_path[parent[task]];
    }
}

void TaskForest::run_leaves_first(const ThreadPool& pool, const Body& body) const {
    if (pool.size() > 1) return run(up_, pool, body);
    for (std::size_t task = 0; task < count(); ++task) body(task, 0);
}

void TaskForest::run_roots_first(const ThreadPool& pool, const Body& body) const {
    if (pool.size() > 1) return run(down_, pool, body);
    for (std::size_t task = count(); task-- > 0;) body(task, 0);
}

void TaskForest::run(const Direction& direction, const ThreadPool& pool, const Body& body) {
    ReadyQueue queue(direction.critical_path, direction.dependency_count);
    const auto work = [&](std::size_t, std::size_t thread) {
        while (!queue.all_started()) {
            if (const auto task = queue.pop()) {
                body(*task, thread);
                queue.release(direction.dependents[*task]);
            } else {
                std::this_thread::yield();
            }
        }
    };
    pool.parallel_for_dynamic(pool.size(), work);
}

}  // namespace rockslope::dda
