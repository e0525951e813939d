#include "blockgen/noding/bucket_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockslope::blockgen {

namespace {

constexpr double segments_per_bucket = 2;
constexpr double short_segments_per_bucket = 4;
constexpr double max_buckets = 1 << 26;

}  // namespace

BucketGrid::BucketGrid(SegmentSpan<const FineSegment> segments, std::int64_t margin,
                       SegmentSpan<const char> listed)
    : margin_(static_cast<double>(margin)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double high_x = -infinity, high_y = -infinity, length = 0;
    low_x_ = low_y_ = infinity;
    for (const FineSegment& s : segments) {
        for (const GridPoint& p : {s.a, s.b}) {
            low_x_ = std::min(low_x_, static_cast<double>(p.x));
            low_y_ = std::min(low_y_, static_cast<double>(p.y));
            high_x = std::max(high_x, static_cast<double>(p.x));
            high_y = std::max(high_y, static_cast<double>(p.y));
        }
        length += std::hypot(static_cast<double>(s.b.x - s.a.x), static_cast<double>(s.b.y - s.a.y));
    }
    if (segments.empty()) low_x_ = low_y_ = high_x = high_y = 0;
    const double span_x = high_x - low_x_ + 2 * margin_, span_y = high_y - low_y_ + 2 * margin_;
    width_ = length > 0 ? segments_per_bucket * span_x * span_y / length : std::max(span_x, span_y);
    // When segments are short compared with their spacing, their number limits the width, not their length.
    width_ = std::min(width_, std::sqrt(short_segments_per_bucket * span_x * span_y /
                                        static_cast<double>(std::max<std::size_t>(segments.size(), 1))));
    width_ = std::max({width_, std::sqrt(span_x * span_y / max_buckets), 4 * margin_,
                       std::max(span_x, span_y) / max_buckets});
    columns_ = static_cast<std::int64_t>(span_x / width_) + 1;
    rows_ = static_cast<std::int64_t>(span_y / width_) + 1;

    first_.assign(columns_ * rows_ + 1, 0);
    const auto is_listed = [&](SegmentIndex k) { return listed.empty() || listed[k]; };
    for (const SegmentIndex k : segments.indices())
        if (is_listed(k)) for_each_bucket(segments[k], [this](std::size_t b) { ++first_[b + 1]; });
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) first_[b + 1] += first_[b];
    items_.resize(first_.back());
    std::vector<std::int64_t> next(first_.begin(), first_.end() - 1);
    for (const SegmentIndex k : segments.indices())
        if (is_listed(k)) for_each_bucket(segments[k], [&](std::size_t b) { items_[next[b]++] = k; });
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
