#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// A segment and the number of what it belongs to.
struct NearSegment {
    Point a, b;
    std::int32_t owner = 0;
    std::int32_t number = 0;  ///< of the segment within its owner
};

/// The point of a segment nearest to p.
Point nearest_point(const NearSegment& segment, const Point& p);

/// Finds the segments near a point by a uniform grid of buckets, about as many as segments. A segment of no
/// length stands for a point.
class NearSegments {
  public:
    /// @param radius the largest distance that is asked for, m.
    NearSegments(const std::vector<NearSegment>& segments, double radius);

    /// Calls visit(segment, nearest point, distance) for each segment within the radius of p, in the order in
    /// which they were given. @param but_of leaves out the segments of this owner.
    template <class Visit>
    void visit_near(const Point& p, std::int32_t but_of, const Visit& visit) const {
        const std::size_t bucket = bucket_of(p);
        for (std::size_t k = first_[bucket]; k < first_[bucket + 1]; ++k) {
            const NearSegment& segment = items_[k];
            if (segment.owner == but_of) continue;
            const Point q = nearest_point(segment, p);
            // Most are farther away, which their squares tell without a root.
            const double dx = q.x - p.x, dy = q.y - p.y;
            if (dx * dx + dy * dy > far_square_) continue;
            if (const double d = distance(p, q); d <= radius_) visit(segment, q, d);
        }
    }

    /// Calls visit(k) for the points [0, count) in turn, and fetches the buckets of those to come: points in
    /// no order wait for memory otherwise. @param point_of the point of which visit(k) asks visit_near().
    template <class PointOf, class Visit>
    void visit_in_turn(std::size_t count, const PointOf& point_of, const Visit& visit) const {
        constexpr std::size_t ahead = 16;
        std::vector<std::uint32_t> buckets(count);
        for (std::size_t k = 0; k < count; ++k)
            buckets[k] = static_cast<std::uint32_t>(bucket_of(point_of(k)));
        for (std::size_t k = 0; k < count; ++k) {
            if (k + 2 * ahead < count) __builtin_prefetch(&first_[buckets[k + 2 * ahead]]);
            if (k + ahead < count) __builtin_prefetch(items_.data() + first_[buckets[k + ahead]]);
            visit(k);
        }
    }

  private:
    static double distance(const Point& p, const Point& q);
    std::int64_t column(double x) const;
    std::int64_t row(double y) const;
    std::size_t bucket_of(const Point& p) const;
    template <class Visit>
    void for_each_bucket(const NearSegment& segment, const Visit& visit) const;

    double radius_ = 0, width_ = 1;
    double far_square_ = 0;  ///< of a distance just above the radius
    Point low_;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> first_;
    std::vector<NearSegment> items_;  ///< copies, so that those of a bucket are read together
};

}  // namespace rockslope::blockgen
