#include "dda/linear/task_forest.hpp"

#include <gtest/gtest.h>

#include <atomic>

namespace rockslope::task_forest_test {
namespace {

const std::vector<int> no_tasks;
const std::vector<int> one_task = {-1};
const std::vector<int> chain = {1, 2, 3, -1};
const std::vector<int> star = {4, 4, 4, 4, -1};
const std::vector<int> two_trees = {2, 2, 6, 5, 5, -1, -1};

class TaskForests : public testing::TestWithParam<std::vector<int>> {};

// Each task runs once: leaves first after its children, roots first after its parent.
TEST_P(TaskForests, RunTasksInOrder) {
    const std::vector<int>& parent = GetParam();
    const std::size_t count = parent.size();
    const dda::TaskForest forest(parent, std::vector<double>(count, 1.0));
    ASSERT_EQ(forest.count(), count);
    for (const int threads : {1, 2, 3}) {
        const ThreadPool pool(threads);
        for (int repetition = 0; repetition < 50; ++repetition) {
            std::vector<std::atomic<int>> runs(count);
            forest.run_leaves_first(pool, [&](std::size_t task, std::size_t thread) {
                EXPECT_LT(thread, static_cast<std::size_t>(threads));
                for (std::size_t k = 0; k < count; ++k) {
                    if (parent[k] == static_cast<int>(task)) {
                        EXPECT_EQ(runs[k], 1);
                    }
                }
                ++runs[task];
            });
            for (const auto& times : runs) EXPECT_EQ(times, 1);
            forest.run_roots_first(pool, [&](std::size_t task, std::size_t) {
                if (parent[task] >= 0) {
                    EXPECT_EQ(runs[parent[task]], 2);
                }
                ++runs[task];
            });
            for (const auto& times : runs) EXPECT_EQ(times, 2);
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Shapes, TaskForests, testing::Values(no_tasks, one_task, chain, star, two_trees));

}  // namespace
}  // namespace rockslope::task_forest_test
