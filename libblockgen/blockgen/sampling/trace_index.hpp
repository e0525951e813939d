#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// Finds the intersections of a line with given traces, by a uniform grid of buckets over a box. There are
/// about as many buckets as segments; a query visits only the buckets along the line.
class TraceIndex {
  public:
    TraceIndex(const std::vector<Trace>& traces, const Bounds& box);

    /// The parameters t in [low, high], ascending, at which p + t u intersects a trace, inside the box only.
    std::vector<double> intersections(const Point& p, const Point& u, double low, double high) const;

  private:
    struct Segment {
        Point a, b;
    };
    template <class Visit>
    void visit_buckets(const Point& a, const Point& b, const Visit& visit) const;
    std::int64_t cell(double offset, std::int64_t count) const;

    Bounds box_;
    double width_ = 1;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<Segment> segments_;
    std::vector<std::vector<std::int32_t>> buckets_;
};

}  // namespace rockslope::blockgen
