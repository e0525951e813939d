#include "dda/contact/corner_meetings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "dda/contact/contact.hpp"

namespace rockslope::corner_meetings_test {
namespace {

struct Candidate {
    dda::CornerEdge pair;
    dda::CornerIndex partner_corner;
    int number = 0;
};
using Meetings = dda::CornerMeetings<Candidate>;
using Numbers = std::vector<int>;

std::vector<Candidate> random_candidates(int count, int corners) {
    std::mt19937 random(7);
    std::vector<Candidate> candidates(count);
    for (int k = 0; k < count; ++k) {
        candidates[k].pair.corner = random() % corners;
        do candidates[k].partner_corner = random() % corners;
        while (candidates[k].partner_corner == candidates[k].pair.corner);
        candidates[k].number = k;
    }
    return candidates;
}

/// The candidates of each meeting, in order.
std::vector<Numbers> numbers_of(const Meetings& meetings) {
    std::vector<Numbers> all(meetings.count());
    for (std::size_t k = 0; k < all.size(); ++k)
        for (const Candidate* candidate : meetings.of(k)) all[k].push_back(candidate->number);
    return all;
}

TEST(CornerMeetings, AreThePairsOfCornersAscendingWithTheirCandidatesAsAdded) {
    constexpr int corners = 700;
    const std::vector<Candidate> candidates = random_candidates(30'000, corners);
    std::map<std::pair<dda::CornerIndex, dda::CornerIndex>, Numbers> expected;
    for (const Candidate& c : candidates)
        expected[std::minmax(c.pair.corner, c.partner_corner)].push_back(c.number);
    std::vector<Numbers> in_order;
    for (const auto& [pair, numbers] : expected) in_order.push_back(numbers);

    for (const int threads : {1, 2, 3}) {
        Meetings meetings;
        Meetings later;
        meetings.reserve(candidates.size());
        for (const Candidate& c : candidates) (c.number < 10'000 ? meetings : later).add(c);
        meetings.add(later);
        meetings.sort(corners, ThreadPool(threads));
        EXPECT_EQ(meetings.size(), candidates.size());
        EXPECT_EQ(meetings.first(meetings.count()), candidates.size());
        EXPECT_EQ(numbers_of(meetings), in_order) << threads;
    }
}

TEST(CornerMeetings, MayBeNone) {
    Meetings meetings;
    meetings.sort(5, ThreadPool());
    EXPECT_EQ(meetings.size(), 0u);
    EXPECT_EQ(meetings.count(), 0u);
}

}  // namespace
}  // namespace rockslope::corner_meetings_test
