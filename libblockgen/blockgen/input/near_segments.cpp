#include "blockgen/input/near_segments.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

Point nearest_point(const NearSegment& segment, const Point& p) {
    const double ux = segment.b.x - segment.a.x, uy = segment.b.y - segment.a.y;
    const double square = ux * ux + uy * uy;
    if (!(square > 0)) return segment.a;
    const double t = ((p.x - segment.a.x) * ux + (p.y - segment.a.y) * uy) / square;
    if (t <= 0) return segment.a;
    if (t >= 1) return segment.b;
    return {segment.a.x + t * ux, segment.a.y + t * uy};
}

double NearSegments::distance(const Point& p, const Point& q) {
    return std::hypot(p.x - q.x, p.y - q.y);
}

NearSegments::NearSegments(const std::vector<NearSegment>& segments, double radius)
    : radius_(radius), far_square_(std::max(radius * radius * (1 + 1e-9), 1e-300)) {
    Ring ends;
    ends.reserve(2 * segments.size() + 1);
    for (const NearSegment& s : segments) ends.insert(ends.end(), {s.a, s.b});
    if (ends.empty()) ends.push_back({});
    const Bounds box = Bounds::of(ends).expanded(radius_);
    low_ = box.low;
    const double span_x = box.high.x - box.low.x, span_y = box.high.y - box.low.y;
    const double buckets = std::clamp(static_cast<double>(segments.size()), 1.0, 4e6);
    width_ = std::max(
        {std::sqrt(span_x * span_y / buckets), std::max(span_x, span_y) / buckets, 2 * radius_, 1e-300});
    columns_ = static_cast<std::int64_t>(span_x / width_) + 1;
    rows_ = static_cast<std::int64_t>(span_y / width_) + 1;
    first_.assign(columns_ * rows_ + 1, 0);
    for (const NearSegment& s : segments) for_each_bucket(s, [this](std::size_t b) { ++first_[b + 1]; });
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) first_[b + 1] += first_[b];
    items_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const NearSegment& s : segments) for_each_bucket(s, [&](std::size_t b) { items_[next[b]++] = s; });
}

std::int64_t NearSegments::column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - low_.x) / width_)), 0,
                                    columns_ - 1);
}

std::int64_t NearSegments::row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - low_.y) / width_)), 0,
                                    rows_ - 1);
}

std::size_t NearSegments::bucket_of(const Point& p) const {
    return static_cast<std::size_t>(column(p.x) * rows_ + row(p.y));
}

/// Visits the buckets within the radius of a segment, column by column, and some more.
template <class Visit>
void NearSegments::for_each_bucket(const NearSegment& segment, const Visit& visit) const {
    Point a = segment.a, b = segment.b;
    if (a.x > b.x) std::swap(a, b);
    const double margin = radius_ * (1 + 1e-9);
    const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
    const std::int64_t last = column(b.x + margin);
    for (std::int64_t c = column(a.x - margin); c <= last; ++c) {
        const double left = low_.x + static_cast<double>(c) * width_ - margin;
        const auto height = [&](double x) { return a.y + slope * (std::clamp(x, a.x, b.x) - a.x); };
        double from = a.y, to = b.y;
        if (b.x > a.x) from = height(left), to = height(left + width_ + 2 * margin);
        const std::int64_t top = row(std::max(from, to) + margin);
        for (std::int64_t r = row(std::min(from, to) - margin); r <= top; ++r)
            visit(static_cast<std::size_t>(c * rows_ + r));
    }
}

}  // namespace rockslope::blockgen
