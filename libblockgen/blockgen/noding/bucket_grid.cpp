#include "blockgen/noding/bucket_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rockslope::blockgen {

namespace {

constexpr double segments_per_bucket = 2;
constexpr double short_segments_per_bucket = 4;
constexpr double max_buckets = 1 << 26;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The box around segments, and their length.
struct Extent {
    double low_x = infinity, low_y = infinity, high_x = -infinity, high_y = -infinity, length = 0;
};

Extent extent_of(SegmentSpan<const FineSegment> segments, std::size_t begin, std::size_t end) {
    Extent extent;
    for (const SegmentIndex k : indices<SegmentIndex>(begin, end)) {
        const auto ax = static_cast<double>(segments[k].a.x), ay = static_cast<double>(segments[k].a.y);
        const auto bx = static_cast<double>(segments[k].b.x), by = static_cast<double>(segments[k].b.y);
        extent.low_x = std::min({extent.low_x, ax, bx});
        extent.low_y = std::min({extent.low_y, ay, by});
        extent.high_x = std::max({extent.high_x, ax, bx});
        extent.high_y = std::max({extent.high_y, ay, by});
        extent.length += std::sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    }
    return extent;
}

Extent joined(const Extent& e, const Extent& f) {
    return {std::min(e.low_x, f.low_x), std::min(e.low_y, f.low_y), std::max(e.high_x, f.high_x),
            std::max(e.high_y, f.high_y), e.length + f.length};
}

}  // namespace

BucketGrid::BucketGrid(SegmentSpan<const FineSegment> segments, std::int64_t margin,
                       SegmentSpan<const char> listed, const ThreadPool& pool)
    : margin_(static_cast<double>(margin)) {
    choose_width(segments, pool);
    fill(segments, listed, pool);
}

void BucketGrid::choose_width(SegmentSpan<const FineSegment> segments, const ThreadPool& pool) {
    const auto part = [&](std::size_t begin, std::size_t end) { return extent_of(segments, begin, end); };
    Extent extent = pool.parallel_reduce(segments.size(), Extent{}, part, joined);
    if (segments.empty()) extent = {0, 0, 0, 0, 0};
    low_x_ = extent.low_x;
    low_y_ = extent.low_y;
    const double span_x = extent.high_x - low_x_ + 2 * margin_, span_y = extent.high_y - low_y_ + 2 * margin_;
    width_ =
        extent.length > 0 ? segments_per_bucket * span_x * span_y / extent.length : std::max(span_x, span_y);
    // When segments are short compared with their spacing, their number limits the width, not their length.
    width_ = std::min(width_, std::sqrt(short_segments_per_bucket * span_x * span_y /
                                        static_cast<double>(std::max<std::size_t>(segments.size(), 1))));
    width_ = std::max({width_, std::sqrt(span_x * span_y / max_buckets), 4 * margin_,
                       std::max(span_x, span_y) / max_buckets});
    columns_ = static_cast<std::int64_t>(span_x / width_) + 1;
    rows_ = static_cast<std::int64_t>(span_y / width_) + 1;
}

/// A counting sort: each thread counts a range of the segments for every bucket, then writes them behind
/// those of the ranges before. A bucket lists its segments in ascending order with any number of threads.
void BucketGrid::fill(SegmentSpan<const FineSegment> segments, SegmentSpan<const char> listed,
                      const ThreadPool& pool) {
    const std::size_t buckets = columns_ * rows_, threads = pool.size();
    const auto visit_range = [&](std::size_t range, const auto& visit) {
        const std::size_t n = segments.size();
        for (const SegmentIndex k : indices<SegmentIndex>(n * range / threads, n * (range + 1) / threads))
            if (listed.empty() || listed[k])
                for_each_bucket(segments[k], [&](std::size_t b) { visit(b, k); });
    };
    std::vector<std::vector<std::uint32_t>> next(threads);
    pool.parallel_for_dynamic(threads, [&](std::size_t range, std::size_t) {
        next[range].assign(buckets, 0);
        visit_range(range, [&](std::size_t b, SegmentIndex) { ++next[range][b]; });
    });
    first_.resize(buckets + 1);
    first_[0] = 0;
    for (std::size_t b = 0; b < buckets; ++b) {
        first_[b + 1] = first_[b];
        for (std::vector<std::uint32_t>& range : next)
            first_[b + 1] += std::exchange(range[b], static_cast<std::uint32_t>(first_[b + 1]));
    }
    items_.resize(first_.back());
    pool.parallel_for_dynamic(threads, [&](std::size_t range, std::size_t) {
        visit_range(range, [&](std::size_t b, SegmentIndex k) { items_[next[range][b]++] = k; });
    });
}

bool BucketGrid::overlaps_occupied_bucket(const FineSegment& segment) const {
    bool near = false;
    for_each_bucket(segment, [&](std::size_t b) { near = near || first_[b + 1] > first_[b]; });
    return near;
}

std::int64_t BucketGrid::column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - low_x_) / width_)), 0,
                                    columns_ - 1);
}

std::int64_t BucketGrid::row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - low_y_) / width_)), 0,
                                    rows_ - 1);
}

std::size_t BucketGrid::bucket_of(const GridPoint& p) const {
    return column(static_cast<double>(p.x)) * rows_ + row(static_cast<double>(p.y));
}

template <class Visit>
void BucketGrid::for_each_bucket(const FineSegment& segment, const Visit& visit) const {
    double ax = static_cast<double>(segment.a.x), ay = static_cast<double>(segment.a.y);
    double bx = static_cast<double>(segment.b.x), by = static_cast<double>(segment.b.y);
    if (ax > bx) std::swap(ax, bx), std::swap(ay, by);
    const double slope = bx > ax ? (by - ay) / (bx - ax) : 0;
    const std::int64_t last = column(bx + margin_);
    for (std::int64_t c = column(ax - margin_); c <= last; ++c) {
        // y range of the segment over this column widened by the margin, clamped to the segment's ends.
        const double left = low_x_ + static_cast<double>(c) * width_ - margin_,
                     right = left + width_ + 2 * margin_;
        const double from = bx > ax ? ay + slope * (std::clamp(left, ax, bx) - ax) : ay;
        const double to = bx > ax ? ay + slope * (std::clamp(right, ax, bx) - ax) : by;
        const std::int64_t top = row(std::max(from, to) + margin_);
        for (std::int64_t r = row(std::min(from, to) - margin_); r <= top; ++r) visit(c * rows_ + r);
    }
}

}  // namespace rockslope::blockgen
