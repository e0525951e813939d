#include "dda/linear/task_forest.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace dda {

namespace {

/// Tasks that need not wait, those with the longest way first, and how many are still to be begun.
class Line {
  public:
    Line(const std::vector<double>& way, std::vector<int> waits_for)
        : way_(way), waits_for_(std::move(waits_for)), to_begin_(waits_for_.size()) {
        for (std::size_t task = 0; task < waits_for_.size(); ++task) {
            if (waits_for_[task] == 0) join(static_cast<int>(task));
        }
    }
    bool is_over() const { return to_begin_ == 0; }
    std::optional<std::size_t> take() {
        const std::lock_guard lock(mutex_);
        if (ready_.empty()) return std::nullopt;
        std::pop_heap(ready_.begin(), ready_.end());
        const int task = ready_.back().second;
        ready_.pop_back();
        --to_begin_;
        return static_cast<std::size_t>(task);
    }
    /// One of those that they wait for has ended.
    void release(const std::vector<int>& tasks) {
        const std::lock_guard lock(mutex_);
        for (const int task : tasks) {
            if (--waits_for_[static_cast<std::size_t>(task)] == 0) join(task);
        }
    }

  private:
    void join(int task) {
        ready_.emplace_back(way_[static_cast<std::size_t>(task)], task);
        std::push_heap(ready_.begin(), ready_.end());
    }

    const std::vector<double>& way_;
    std::mutex mutex_;
    std::vector<int> waits_for_;
    std::vector<std::pair<double, int>> ready_;
    std::atomic<std::size_t> to_begin_;
};

}  // namespace

TaskForest::TaskForest(const std::vector<int>& parent, const std::vector<double>& cost) {
    const std::size_t count = parent.size();
    up_ = {std::vector<std::vector<int>>(count), std::vector<int>(count, 0), cost};
    down_ = up_;
    std::vector<double> longest_below(count, 0);
    for (std::size_t task = 0; task < count; ++task) {
        down_.way[task] += longest_below[task];
        if (parent[task] < 0) continue;
        const auto above = static_cast<std::size_t>(parent[task]);
        assert(task < above);
        up_.next[task].push_back(parent[task]);
        ++up_.waits_for[above];
        down_.next[above].push_back(static_cast<int>(task));
        down_.waits_for[task] = 1;
        longest_below[above] = std::max(longest_below[above], down_.way[task]);
    }
    for (std::size_t task = count; task-- > 0;) {
        if (parent[task] >= 0) up_.way[task] += up_.way[static_cast<std::size_t>(parent[task])];
    }
}

void TaskForest::rise(const Crew& crew, const Body& body) const {
    if (crew.size() > 1) return go(up_, crew, body);
    for (std::size_t task = 0; task < count(); ++task) body(task, 0);
}

void TaskForest::descend(const Crew& crew, const Body& body) const {
    if (crew.size() > 1) return go(down_, crew, body);
    for (std::size_t task = count(); task-- > 0;) body(task, 0);
}

void TaskForest::go(const Direction& direction, const Crew& crew, const Body& body) {
    Line line(direction.way, direction.waits_for);
    const auto take_part = [&](std::size_t, std::size_t thread) {
        while (!line.is_over()) {
            if (const auto task = line.take()) {
                body(*task, thread);
                line.release(direction.next[*task]);
            } else {
                std::this_thread::yield();
            }
        }
    };
    crew.for_tasks(static_cast<std::size_t>(crew.size()), take_part);
}

}  // namespace dda
