#include "blockgen/noding/bucket_grid.hpp"

#include <gtest/gtest.h>

namespace rockslope::blockgen::bucket_grid_test {
namespace {

/// Number of pairs of segments that share a bucket, over all buckets, per segment: the work of finding
/// crossings.
double pairs_per_segment(std::int64_t columns, std::int64_t spacing, std::int64_t length) {
    std::vector<FineSegment> segments;
    for (std::int64_t i = 0; i < columns; ++i)
        for (std::int64_t j = 0; j < columns; ++j)
            segments.push_back(
                {{i * spacing, j * spacing}, {i * spacing + length, j * spacing + length / 3}});
    const BucketGrid grid(segments, 1);
    double pairs = 0;
    for (std::size_t b = 0; b < grid.column_count() * grid.row_count(); ++b) {
        const auto near = static_cast<double>(grid.segments_of(b).size());
        pairs += near * (near - 1) / 2;
    }
    return pairs / static_cast<double>(segments.size());
}

// The work per segment is bounded for any number of segments, from short segments far apart to segments as
// long as their spacing.
TEST(BucketGrid, WorkPerSegmentIsBounded) {
    for (const std::int64_t columns : {30, 100, 300})
        for (const std::int64_t length : {10, 1000, 10'000})
            EXPECT_LT(pairs_per_segment(columns, 10'000, length), 30) << columns << ' ' << length;
}

}  // namespace
}  // namespace rockslope::blockgen::bucket_grid_test
