#include "common/base/parallel_parts.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace rockslope::parallel_parts_test {
namespace {

std::vector<std::size_t> range(std::size_t begin, std::size_t end) {
    std::vector<std::size_t> numbers(end - begin);
    std::iota(numbers.begin(), numbers.end(), begin);
    return numbers;
}

TEST(ParallelParts, CoverTheRangeInOrderWithAnyNumberOfThreads) {
    for (const std::size_t count : {0, 1, 511, 512, 12'345}) {
        for (const int threads : {1, 2, 5}) {
            const auto parts = parallel_parts(ThreadPool(threads), count, range);
            std::vector<std::size_t> joined;
            for (const std::vector<std::size_t>& part : parts) append(joined, part);
            EXPECT_EQ(joined, range(0, count)) << count << ' ' << threads;
            EXPECT_EQ(parts.size(), count < 512 ? 1u : static_cast<std::size_t>(threads));
        }
    }
}

}  // namespace
}  // namespace rockslope::parallel_parts_test
