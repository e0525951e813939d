#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/noding/snap_round.hpp"

namespace rockslope::blockgen {

/// A uniform grid of buckets over segments: bucket i lists every segment that comes within `margin` of it.
/// The buckets are as wide as makes the lists about two long, or four where segments are short beside their
/// distance from each other, so that work per bucket is bounded for evenly spread segments.
class BucketGrid {
  public:
    /// @param listed when given, a flag per segment: the lists hold only the flagged ones, the width is that
    /// for all.
    BucketGrid(std::span<const FineSegment> segments, std::int64_t margin, std::span<const char> listed = {});

    std::size_t bucket_count() const { return first_.size() - 1; }
    std::span<const std::int32_t> segments_of(std::size_t bucket) const {
        return std::span(items_).subspan(static_cast<std::size_t>(first_[bucket]),
                                         static_cast<std::size_t>(first_[bucket + 1] - first_[bucket]));
    }
    /// The bucket that holds a point; points outside count to the nearest.
    std::size_t bucket_of(const GridPoint& p) const;
    /// Whether a segment comes within the margin of a bucket that lists any.
    bool overlaps_occupied_bucket(const FineSegment& segment) const;
    /// Buckets are numbered upwards, column after column, as sorted segments come: the one below another,
    /// where its row is not 0, is the one before it.
    std::int64_t row_of(std::size_t bucket) const { return static_cast<std::int64_t>(bucket) % rows_; }
    /// The height of a bucket's lower side.
    double bottom_of(std::size_t bucket) const {
        return low_y_ + width_ * static_cast<double>(row_of(bucket));
    }

  private:
    template <class Visit>
    void for_each_bucket(const FineSegment& segment, const Visit& visit) const;
    std::int64_t column(double x) const;
    std::int64_t row(double y) const;

    double low_x_ = 0, low_y_ = 0, width_ = 1, margin_ = 0;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<std::int64_t> first_;
    std::vector<std::int32_t> items_;
};

}  // namespace rockslope::blockgen
