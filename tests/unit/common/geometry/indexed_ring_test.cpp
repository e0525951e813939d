#include "common/geometry/indexed_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rockslope::indexed_ring_test {
namespace {

double uniform_number(std::mt19937_64& generator) {
    return (static_cast<double>(generator() >> 11u) + 0.5) * 0x1p-53;
}

/// A star of `corners` whose radii differ, round a far point.
Ring star(std::size_t corners, const Point& middle) {
    std::mt19937_64 generator(corners);
    Ring ring;
    for (std::size_t k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
        const double radius = 4 + 6 * uniform_number(generator);
        ring.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
    }
    return ring;
}

/// Rings that test what a tree of boxes may miss: few edges, upright ones, whole coordinates, no width.
std::vector<Ring> rings() {
    std::vector<Ring> all;
    for (const std::size_t corners : {3u, 8u, 9u, 17u, 100u, 1000u}) all.push_back(star(corners, {5, 5}));
    all.push_back(star(50, {466005, 6691505}));
    all.push_back({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    Ring comb;  // of teeth, whose ring has upright edges and runs there and back at the end
    for (int k = 0; k < 10; ++k) {
        comb.push_back({1.0 * k, k % 2 == 0 ? 8.0 : 3.0});
        comb.push_back({1.0 * k + 1, k % 2 == 0 ? 8.0 : 3.0});
    }
    comb.insert(comb.end(), {{12, 3}, {10, 3}, {10, 0}, {0, 0}});
    all.push_back(comb);
    return all;
}

TEST(IndexedRing, FindsWhatATestOfAllEdgesFinds) {
    for (const Ring& ring : rings()) {
        const IndexedRing index(ring);
        const Bounds box = Bounds::of(ring).expanded(1);
        std::mt19937_64 generator(1);
        const auto random_point = [&] {
            return Point{box.low.x + uniform_number(generator) * (box.high.x - box.low.x),
                         box.low.y + uniform_number(generator) * (box.high.y - box.low.y)};
        };
        for (int k = 0; k < 2000; ++k) {
            Point a = random_point(), b = random_point();
            if (k % 4 == 1) a = ring[static_cast<std::size_t>(k) % ring.size()];
            if (k % 4 == 2) a = {std::round(a.x), std::round(a.y)}, b = {std::round(b.x), std::round(b.y)};
            if (k % 8 == 3) b.x = a.x;
            if (k % 8 == 7) b.y = a.y;
            EXPECT_EQ(index.side(a), side_of_ring(ring, a)) << ring.size() << ": " << a.x << ' ' << a.y;
            EXPECT_EQ(index.clip(a, b), clip_to_ring(a, b, ring)) << ring.size() << ": " << a.x << ' ' << a.y;
        }
        for (const Point& corner : ring) EXPECT_EQ(index.side(corner), 0);
    }
}

TEST(IndexedRing, OfAnEmptyRingHasNothingInside) {
    EXPECT_EQ(IndexedRing({}).side({0, 0}), -1);
    EXPECT_TRUE(IndexedRing({}).clip({0, 0}, {1, 1}).empty());
}

}  // namespace
}  // namespace rockslope::indexed_ring_test
