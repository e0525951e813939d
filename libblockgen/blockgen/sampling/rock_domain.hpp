#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/geometry/indexed_ring.hpp"

namespace rockslope::blockgen {

/// A straight piece between two points.
using Piece = std::pair<Point, Point>;

/// The rock in which a joint set lies: all rock of the domain, or the rock in the set's region.
class RockDomain {
  public:
    RockDomain(const SlopeModel& model, const std::string& region);

    /// Area of the rock, m2, computed exactly on the model's grid.
    double area() const { return area_; }
    /// Length of a segment in the rock, m.
    double length_in(const Point& a, const Point& b) const;
    bool contains(const Point& p) const;
    /// The pieces of a segment in the region; the whole segment when the set has no region.
    std::vector<Piece> pieces_in_region(const Point& a, const Point& b) const;
    /// The pieces along which traces run again where an earlier one, or they themselves, ran: one for each
    /// further time. Their ends are rounded to the model's grid, and pieces outside the domain may be absent.
    std::vector<Piece> repeated_pieces(const std::vector<Trace>& traces) const;

  private:
    double length_in_part(const Point& a, const Point& b, const IndexedRing& part) const;

    const SlopeModel& model_;
    std::optional<IndexedRing> region_;
    std::vector<IndexedRing> parts_;     ///< the outlines
    std::vector<IndexedRing> cavities_;  ///< holes and tunnels
    double area_ = 0;
};

}  // namespace rockslope::blockgen
