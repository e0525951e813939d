#include "common/base/thread_pool.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rockslope::thread_pool_test {
namespace {

class ThreadPoolSizes : public testing::TestWithParam<int> {};

// The lengths include those around min_parallel_length and one that no pool size divides.
TEST_P(ThreadPoolSizes, CallsEachIndexOnce) {
    const ThreadPool pool(GetParam());
    for (const std::size_t count : {0u, 1u, 7u, 511u, 512u, 513u, 10007u}) {
        std::vector<int> visits(count, 0);
        pool.parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) ++visits[k];
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " indices, " << GetParam() << " threads";
    }
}

TEST_P(ThreadPoolSizes, RethrowsAnExceptionInTheCaller) {
    const ThreadPool pool(GetParam());
    for (const std::size_t failing : {0u, 9999u}) {
        const auto body = [&](std::size_t begin, std::size_t end) {
            if (begin <= failing && failing < end)
                throw std::runtime_error("index " + std::to_string(failing));
        };
        EXPECT_THROW(pool.parallel_for(10000, body), std::runtime_error);
    }
    std::atomic<int> sum = 0;
    pool.parallel_for(10000,
                      [&](std::size_t begin, std::size_t end) { sum += static_cast<int>(end - begin); });
    EXPECT_EQ(sum, 10000) << "the pool must work after a failure";
}

TEST_P(ThreadPoolSizes, RunsEachTaskOnceWithItsThreadIndex) {
    const ThreadPool pool(GetParam());
    for (const std::size_t count : {0u, 1u, 2u, 5u, 300u}) {
        std::vector<std::thread::id> thread_id(count);
        std::vector<std::size_t> thread(count, 99);
        std::vector<int> visits(count, 0);
        pool.parallel_for_dynamic(count, [&](std::size_t task, std::size_t t) {
            ++visits[task];
            thread[task] = t;
            thread_id[task] = std::this_thread::get_id();
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1));
        for (std::size_t a = 0; a < count; ++a) {
            EXPECT_LT(thread[a], static_cast<std::size_t>(pool.size()));
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_TRUE(thread[a] != thread[b] || thread_id[a] == thread_id[b]);
        }
    }
}

TEST_P(ThreadPoolSizes, RethrowsAnExceptionOfATaskInTheCaller) {
    const ThreadPool pool(GetParam());
    const auto fail = [](std::size_t task, std::size_t) {
        if (task == 3) throw std::runtime_error("task 3");
    };
    EXPECT_THROW(pool.parallel_for_dynamic(20, fail), std::runtime_error);
}
INSTANTIATE_TEST_SUITE_P(Threads, ThreadPoolSizes, testing::Values(1, 2, 3, 5),
                         testing::PrintToStringParamName());

TEST(ThreadPool, HasAtLeastOneThread) {
    EXPECT_EQ(ThreadPool(0).size(), 1);
    EXPECT_EQ(ThreadPool(-10).size(), 1);
    EXPECT_EQ(ThreadPool(2).size(), 2);
}

/// Waits until both threads of a pool are in the same loop.
class Rendezvous {
  public:
    void arrive() {
        ++arrived_;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (arrived_ < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    }
    bool is_complete() const { return arrived_ == 2; }

  private:
    std::atomic<int> arrived_ = 0;
};

TEST(ThreadPool, SplitsLongLoopsAmongThreads) {
    const ThreadPool pool(2);
    Rendezvous rendezvous;
    pool.parallel_for(10000, [&](std::size_t, std::size_t) { rendezvous.arrive(); });
    EXPECT_TRUE(rendezvous.is_complete());
}

TEST(ThreadPool, WakesSleepingThreads) {
    const ThreadPool pool(2);
    for (const int idle_ms : {0, 1, 20}) {
        std::this_thread::sleep_for(std::chrono::milliseconds(idle_ms));
        Rendezvous rendezvous;
        pool.parallel_for_dynamic(2, [&](std::size_t, std::size_t) { rendezvous.arrive(); });
        EXPECT_TRUE(rendezvous.is_complete()) << "after " << idle_ms << " ms";
    }
}

// Other threads of the process, such as those of a BLAS library, may take a while to fall asleep.
TEST(ThreadPool, IdleThreadsSleep) {
    const ThreadPool pool(2);
    pool.parallel_for_dynamic(2, [](std::size_t, std::size_t) {});
    double busy = 1;  // CPU time of the process over a tenth of a second
    for (int attempt = 0; attempt < 20 && busy > 0.2; ++attempt) {
        const std::clock_t before = std::clock();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        busy = 10 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    }
    EXPECT_LE(busy, 0.2);
}

// In many short loops some workers join early, some late and some not at all.
TEST(ThreadPool, RunsEveryTaskExactlyOnce) {
    const ThreadPool pool(3);
    for (int round = 0; round < 20000; ++round) {
        std::array<int, 5> visits{};
        pool.parallel_for_dynamic(visits.size(), [&](std::size_t k, std::size_t) { ++visits[k]; });
        ASSERT_EQ(visits, (std::array{1, 1, 1, 1, 1})) << "round " << round;
    }
}

TEST(ThreadPool, ReducesToTheSameBytesOnAnyNumberOfThreads) {
    for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 4096u, 4097u, 100003u}) {
        const auto sum = [&](int threads) {
            return ThreadPool(threads).parallel_reduce(
                count, 0.5,
                [](std::size_t begin, std::size_t end) {
                    double chunk = 0;
                    for (std::size_t k = begin; k < end; ++k) chunk += 1 / static_cast<double>(k + 1);
                    return chunk;
                },
                std::plus<>());
        };
        const double serial = sum(1);
        double expected = 0.5;
        for (std::size_t k = 0; k < count; ++k) expected += 1 / static_cast<double>(k + 1);
        EXPECT_NEAR(serial, expected, 1e-12 * expected) << count;
        for (const int threads : {2, 3, 5}) EXPECT_EQ(sum(threads), serial) << count << ", " << threads;
    }
}

}  // namespace
}  // namespace rockslope::thread_pool_test
