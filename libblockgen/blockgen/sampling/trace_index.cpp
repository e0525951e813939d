#include "blockgen/sampling/trace_index.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::blockgen {

TraceIndex::TraceIndex(const std::vector<Trace>& traces, const Bounds& box) : box_(box) {
    for (const Trace& trace : traces)
        for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
            const Point &a = trace.points[k], &b = trace.points[k + 1];
            const auto inside = box.clip(a, {b.x - a.x, b.y - a.y});
            if (inside && inside->first <= 1 && inside->second >= 0) segments_.push_back({a, b});
        }
    const double span_x = box.high.x - box.low.x, span_y = box.high.y - box.low.y;
    const double bucket_count = std::clamp(static_cast<double>(segments_.size()), 1.0, 1e6);
    width_ = std::max(std::sqrt(span_x * span_y / bucket_count), std::max(span_x, span_y) / 1e4);
    columns_ = static_cast<std::int64_t>(span_x / width_) + 1;
    rows_ = static_cast<std::int64_t>(span_y / width_) + 1;
    buckets_.resize(columns_ * rows_);
    for (std::size_t s = 0; s < segments_.size(); ++s)
        visit_buckets(segments_[s].a, segments_[s].b,
                      [&](std::size_t bucket) { buckets_[bucket].push_back(s); });
}

std::int64_t TraceIndex::cell(double offset, std::int64_t count) const {
    return static_cast<std::int64_t>(
        std::clamp(std::floor(offset / width_), 0.0, static_cast<double>(count - 1)));
}

/// Visits the buckets that a segment crosses, column by column. The segment is widened by 1e-3 of a bucket
/// width to allow for rounding.
template <class Visit>
void TraceIndex::visit_buckets(const Point& a, const Point& b, const Visit& visit) const {
    const auto inside = box_.clip(a, {b.x - a.x, b.y - a.y});
    if (!inside) return;
    const double from = std::max(inside->first, 0.0), to = std::min(inside->second, 1.0);
    Point p{a.x + from * (b.x - a.x), a.y + from * (b.y - a.y)};
    Point q{a.x + to * (b.x - a.x), a.y + to * (b.y - a.y)};
    if (p.x > q.x) std::swap(p, q);
    const double margin = 1e-3 * width_, slope = q.x > p.x ? (q.y - p.y) / (q.x - p.x) : 0;
    const std::int64_t last = cell(q.x - box_.low.x + margin, columns_);
    for (std::int64_t c = cell(p.x - box_.low.x - margin, columns_); c <= last; ++c) {
        const double left = box_.low.x + static_cast<double>(c) * width_ - margin;
        const auto height = [&](double x) { return p.y + slope * (std::clamp(x, p.x, q.x) - p.x); };
        double y = height(left), z = height(left + width_ + 2 * margin);
        if (p.x == q.x) y = p.y, z = q.y;
        const std::int64_t top = cell(std::max(y, z) - box_.low.y + margin, rows_);
        for (std::int64_t r = cell(std::min(y, z) - box_.low.y - margin, rows_); r <= top; ++r)
            visit(r * columns_ + c);
    }
}

std::vector<double> TraceIndex::intersections(const Point& p, const Point& u, double low, double high) const {
    std::vector<std::int32_t> near;
    visit_buckets({p.x + low * u.x, p.y + low * u.y}, {p.x + high * u.x, p.y + high * u.y},
                  [&](std::size_t b) { near.insert(near.end(), buckets_[b].begin(), buckets_[b].end()); });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<double> distances;
    for (const std::int32_t k : near) {
        const auto& [a, b] = segments_[k];
        const double vx = b.x - a.x, vy = b.y - a.y, denominator = u.x * vy - u.y * vx;
        if (denominator == 0) continue;
        const double t = ((a.x - p.x) * vy - (a.y - p.y) * vx) / denominator;
        const double s = ((a.x - p.x) * u.y - (a.y - p.y) * u.x) / denominator;
        if (t >= low && t <= high && s >= 0 && s <= 1) distances.push_back(t);
    }
    std::sort(distances.begin(), distances.end());
    return distances;
}

}  // namespace rockslope::blockgen
