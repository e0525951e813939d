#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "dda/base/parallel.hpp"

namespace dda {

/// Tasks of which each waits for others: its children in the one direction, its parent in the other. Whoever
/// of a crew is free takes, of those that need not wait any more, the one that heads the longest way.
class TaskForest {
  public:
    /// Does a task in a thread, which counts from zero. It throws nothing.
    using Body = std::function<void(std::size_t task, std::size_t thread)>;

    TaskForest() = default;
    /// @param parent per task, a later one, -1 for a root; @param cost per task, in any unit.
    TaskForest(const std::vector<int>& parent, const std::vector<double>& cost);

    std::size_t count() const { return up_.way.size(); }
    /// Calls body(task, thread) for each task, for its children before.
    void rise(const Crew& crew, const Body& body) const;
    /// Likewise, for its parent before.
    void descend(const Crew& crew, const Body& body) const;

  private:
    /// One of the two directions.
    struct Direction {
        std::vector<std::vector<int>> next;  ///< per task, those that wait for it
        std::vector<int> waits_for;          ///< per task, how many
        std::vector<double> way;             ///< per task, the cost from it to the end
    };
    static void go(const Direction& direction, const Crew& crew, const Body& body);

    Direction up_;
    Direction down_;
};

}  // namespace dda
