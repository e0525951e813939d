#include "blockgen/noding/cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rockslope::blockgen::cells_test {
namespace {

constexpr std::int64_t units = 4096;

Int128 floor_of(Int128 numerator, Int128 denominator) {
    Int128 quotient = numerator / denominator;
    while (quotient * denominator > numerator) --quotient;
    return quotient;
}

/// The cell of the crossing by the definition, in integers only.
std::optional<GridPoint> by_definition(const FineSegment& s, const FineSegment& t) {
    if (s.a == t.a || s.b == t.b || s.a == t.b || s.b == t.a) return std::nullopt;
    const GridPoint u{s.b.x - s.a.x, s.b.y - s.a.y}, v{t.b.x - t.a.x, t.b.y - t.a.y};
    const GridPoint w{t.a.x - s.a.x, t.a.y - s.a.y};
    const auto cross = [](const GridPoint& p, const GridPoint& q) {
        return static_cast<Int128>(p.x) * q.y - static_cast<Int128>(p.y) * q.x;
    };
    Int128 denominator = cross(u, v), along_s = cross(w, v), along_t = cross(w, u);
    if (denominator == 0) return std::nullopt;
    if (denominator < 0) denominator = -denominator, along_s = -along_s, along_t = -along_t;
    if (std::min(along_s, along_t) < 0 || std::max(along_s, along_t) > denominator) return std::nullopt;
    const auto cell = [&](std::int64_t start, std::int64_t component) {
        return static_cast<std::int64_t>(
            floor_of(along_s * component + (start + units / 2) * denominator, denominator * units));
    };
    return GridPoint{cell(s.a.x, u.x), cell(s.a.y, u.y)};
}

/// Points of which many lie on each other's lines and on the sides of cells, from near the origin to the
/// limit of the coordinates.
GridPoint random_point(std::mt19937_64& random, int bits) {
    const std::int64_t span = std::int64_t{1} << bits;
    const auto coordinate = [&] {
        const auto any = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * span)) - span;
        return random() % 2 == 0 ? any : any / (units / 2) * (units / 2);
    };
    return {coordinate(), coordinate()};
}

TEST(CrossingCell, IsThatOfIntegersWhateverDoublesRound) {
    std::mt19937_64 random(7);
    std::size_t crossings = 0, touching = 0;
    for (const int bits : {3, 12, 14, 20, 30, 39})
        for (int k = 0; k < 20'000; ++k) {
            const FineSegment s{random_point(random, bits), random_point(random, bits)};
            FineSegment t{random_point(random, bits), random_point(random, bits)};
            // An end on the other segment, or one unit beside it, or nearly the same direction.
            const std::int64_t nudge = static_cast<std::int64_t>(random() % 3) - 1;
            if (k % 3 == 1) t.a = {(s.a.x + s.b.x) / 2, (s.a.y + s.b.y) / 2 + nudge};
            if (k % 3 == 2) t = {{s.a.x + nudge, s.a.y}, {s.b.x - nudge, s.b.y + 1}};
            const auto expected = by_definition(s, t);
            ASSERT_EQ(crossing_cell(s, t, units), expected) << bits << ' ' << k;
            crossings += expected.has_value();
            touching += k % 3 == 1 && expected.has_value();
        }
    EXPECT_GT(crossings, 20'000u);
    EXPECT_GT(touching, 10'000u);
}

}  // namespace
}  // namespace rockslope::blockgen::cells_test
