#include "common/base/parallel_filter.hpp"

#include <gtest/gtest.h>

namespace rockslope::parallel_filter_test {
namespace {

TEST(ParallelFilter, FindsTheSelectedIndicesInOrderWithAnyNumberOfThreads) {
    const auto is_selected = [](std::size_t k) { return k % 7 == 2 || k % 64 == 63; };
    for (const std::size_t count : {0, 1, 3, 511, 512, 12'345}) {
        std::vector<std::size_t> expected;
        for (std::size_t k = 0; k < count; ++k)
            if (is_selected(k)) expected.push_back(k);
        for (const int threads : {1, 2, 5})
            EXPECT_EQ(parallel_filter(ThreadPool(threads), count, is_selected), expected)
                << count << ' ' << threads;
    }
}

TEST(ParallelFilter, ForgetsWhatItsWorkSpaceHeld) {
    std::vector<char> selected;
    std::vector<std::size_t> indices;
    const ThreadPool pool(1);
    parallel_filter(
        pool, 5, [](std::size_t /*unused*/) { return true; }, selected, indices);
    parallel_filter(
        pool, 3, [](std::size_t k) { return k == 1; }, selected, indices);
    EXPECT_EQ(indices, std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace rockslope::parallel_filter_test
