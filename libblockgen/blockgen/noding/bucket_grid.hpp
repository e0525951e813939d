#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/noding/snap_round.hpp"

namespace rockslope::blockgen {

/// A uniform grid of square buckets over segments. Bucket i lists every segment within `margin` of it.
/// The bucket width gives lists of about two segments, or about four when the segments are short compared
/// with their spacing. The work per bucket is then bounded for evenly spread segments.
class BucketGrid {
  public:
    /// @param listed flag per segment: only flagged segments are listed. Empty: all are. All segments count
    /// for the bucket width.
    BucketGrid(SegmentSpan<const FineSegment> segments, std::int64_t margin,
               SegmentSpan<const char> listed = {}, const ThreadPool& pool = ThreadPool());

    /// The segments that pass through a bucket.
    std::span<const SegmentIndex> segments_of(std::size_t bucket) const {
        return std::span(items_).subspan(first_[bucket], first_[bucket + 1] - first_[bucket]);
    }
    /// The bucket that contains a point; for a point outside the grid, the nearest bucket.
    std::size_t bucket_of(const GridPoint& p) const;
    /// Whether a segment comes within the margin of a bucket that lists a segment.
    bool overlaps_occupied_bucket(const FineSegment& segment) const;
    /// Row of a bucket, counted from the bottom. Buckets are numbered column by column, upwards in each, so
    /// the bucket below bucket k in the same column is k - 1.
    std::int64_t row_of(std::size_t bucket) const { return static_cast<std::int64_t>(bucket) % rows_; }
    /// Number of columns of buckets.
    std::size_t column_count() const { return columns_; }
    /// Number of rows of buckets.
    std::size_t row_count() const { return rows_; }
    /// y coordinate of a bucket's lower side.
    double bottom_of(std::size_t bucket) const {
        return low_y_ + width_ * static_cast<double>(row_of(bucket));
    }

  private:
    void choose_width(SegmentSpan<const FineSegment> segments, const ThreadPool& pool);
    void fill(SegmentSpan<const FineSegment> segments, SegmentSpan<const char> listed,
              const ThreadPool& pool);
    template <class Visit>
    void for_each_bucket(const FineSegment& segment, const Visit& visit) const;
    std::int64_t column(double x) const;
    std::int64_t row(double y) const;

    double low_x_ = 0, low_y_ = 0, width_ = 1, margin_ = 0;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<std::int64_t> first_;
    std::vector<SegmentIndex> items_;
};

}  // namespace rockslope::blockgen
