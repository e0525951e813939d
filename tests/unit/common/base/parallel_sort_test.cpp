#include "common/base/parallel_sort.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rockslope::parallel_sort_test {
namespace {

TEST(ParallelSort, SortsAsOneThreadDoes) {
    std::mt19937 random(3);
    for (const std::size_t count : {0u, 1u, 1000u, 200'001u}) {
        std::vector<unsigned> values(count);
        for (unsigned& value : values) value = static_cast<unsigned>(random() % 50'000);
        std::vector<unsigned> expected = values;
        std::sort(expected.begin(), expected.end());
        for (const int threads : {1, 2, 3, 8}) {
            std::vector<unsigned> sorted = values;
            parallel_sort(ThreadPool(threads), sorted);
            EXPECT_EQ(sorted, expected) << count << ' ' << threads;
        }
    }
}

}  // namespace
}  // namespace rockslope::parallel_sort_test
