#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope {

/// Vertical lines through a set of rings whose interiors do not overlap.
class VerticalSections {
  public:
    /// @param rings turn either way.
    explicit VerticalSections(const std::vector<Ring>& rings);

    /// What a vertical line meets.
    struct Section {
        std::optional<double> top;  ///< m, y of its highest point on a ring; nothing where it meets none
        double length = 0;          ///< m, of its parts inside the rings
    };
    /// The line at x. Where a ring begins or ends there, top and length are each the larger of their two
    /// limits.
    Section at(double x) const;
    /// The limits of top and length from the left of x.
    Section left_of(double x) const;
    /// The limits from the right of x.
    Section right_of(double x) const;

    /// The x of all corners, in increasing order, each once: top and length are linear between them, but for
    /// edges that cross.
    const std::vector<double>& corners() const { return corners_; }

  private:
    /// An edge of a ring, from left to right.
    struct Edge {
        Point left, right;
        double sign = 1;  ///< +1: the ring is below it
    };
    template <class Crosses>
    Section section(double x, const Crosses& crosses) const;
    std::size_t bucket_of(double x) const;

    std::vector<Edge> edges_;
    std::vector<double> corners_;
    std::vector<std::vector<std::size_t>> buckets_;  ///< edges by intervals of x
};

}  // namespace rockslope
