#include "dda/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using dda::Crew;

class CrewSizes : public testing::TestWithParam<int> {};

// Lengths on both sides of the one below which a loop stays in the calling thread, and not divisible by the
// crew's size.
TEST_P(CrewSizes, VisitsEachIndexOnce) {
    const Crew crew(GetParam());
    for (const std::size_t count : {0u, 1u, 7u, 511u, 512u, 513u, 10007u}) {
        std::vector<int> visits(count, 0);
        crew.for_ranges(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) ++visits[k];
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " indices, " << GetParam() << " threads";
    }
}

TEST_P(CrewSizes, CarriesAnExceptionToTheCaller) {
    const Crew crew(GetParam());
    for (const std::size_t failing : {0u, 9999u}) {
        const auto body = [&](std::size_t begin, std::size_t end) {
            if (begin <= failing && failing < end)
                throw std::runtime_error("index " + std::to_string(failing));
        };
        EXPECT_THROW(crew.for_ranges(10000, body), std::runtime_error);
    }
    std::atomic<int> sum = 0;
    crew.for_ranges(10000, [&](std::size_t begin, std::size_t end) { sum += static_cast<int>(end - begin); });
    EXPECT_EQ(sum, 10000) << "the crew works on after a failure";
}

TEST_P(CrewSizes, DoesEachTaskOnceByAThreadOfItsOwn) {
    const Crew crew(GetParam());
    for (const std::size_t count : {0u, 1u, 2u, 5u, 300u}) {
        std::vector<std::thread::id> by(count);
        std::vector<std::size_t> thread(count, 99);
        std::vector<int> visits(count, 0);
        crew.for_tasks(count, [&](std::size_t task, std::size_t t) {
            ++visits[task];
            thread[task] = t;
            by[task] = std::this_thread::get_id();
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1));
        for (std::size_t a = 0; a < count; ++a) {
            EXPECT_LT(thread[a], static_cast<std::size_t>(crew.size()));
            for (std::size_t b = 0; b < a; ++b) EXPECT_TRUE(thread[a] != thread[b] || by[a] == by[b]);
        }
    }
}

TEST_P(CrewSizes, CarriesATasksExceptionToTheCaller) {
    const Crew crew(GetParam());
    const auto fail = [](std::size_t task, std::size_t) {
        if (task == 3) throw std::runtime_error("task 3");
    };
    EXPECT_THROW(crew.for_tasks(20, fail), std::runtime_error);
}
INSTANTIATE_TEST_SUITE_P(Threads, CrewSizes, testing::Values(1, 2, 3, 5), testing::PrintToStringParamName());

TEST(Crew, HasAtLeastOneThread) {
    EXPECT_EQ(Crew(0).size(), 1);
    EXPECT_EQ(Crew(-10).size(), 1);
    EXPECT_EQ(Crew(2).size(), 2);
}

TEST(Crew, SharesLongLoops) {
    const Crew crew(2);
    std::vector<std::thread::id> by(10000);
    crew.for_ranges(by.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) by[k] = std::this_thread::get_id();
    });
    EXPECT_EQ(by.front(), std::this_thread::get_id());
    EXPECT_NE(by.back(), std::this_thread::get_id());
}

}  // namespace
