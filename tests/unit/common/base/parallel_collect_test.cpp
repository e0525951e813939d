#include "common/base/parallel_collect.hpp"

#include <gtest/gtest.h>

namespace rockslope::parallel_collect_test {
namespace {

TEST(ParallelCollect, JoinsTheListsInOrderWithAnyNumberOfThreads) {
    for (const std::size_t count : {0, 1, 15, 16, 1000, 12'345}) {
        std::vector<std::size_t> expected;
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t i = 0; i < k % 3; ++i) expected.push_back(k);
        for (const int threads : {1, 2, 5}) {
            const ThreadPool pool(threads);
            const auto list = parallel_collect<std::size_t>(
                pool, count, [](std::size_t begin, std::size_t end, std::vector<std::size_t>& out) {
                    for (std::size_t k = begin; k < end; ++k)
                        for (std::size_t i = 0; i < k % 3; ++i) out.push_back(k);
                });
            EXPECT_EQ(list, expected) << count << ' ' << threads;
        }
    }
}

}  // namespace
}  // namespace rockslope::parallel_collect_test
