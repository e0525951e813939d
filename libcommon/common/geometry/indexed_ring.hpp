#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "common/geometry/clip_line.hpp"

namespace rockslope {

/// A ring with a tree of boxes round its edges, for many queries: of n edges a query looks at about log n
/// boxes and the edges near its place, where side_of_ring() and clip_to_ring() look at all edges.
class IndexedRing {
  public:
    explicit IndexedRing(const Ring& ring);  ///< keeps a copy of the ring

    /// The value of side_of_ring().
    int side(const Point& point) const;
    /// The pieces of clip_to_ring(), with the same coordinates.
    std::vector<std::pair<Point, Point>> clip(const Point& a, const Point& b) const;

  private:
    /// The edges [first, last) and the box round them; its halves are the nodes 2 k + 1 and 2 k + 2 of node
    /// k.
    template <class Visit>
    void visit_edges(const Bounds& box, const Visit& visit, std::size_t node, std::size_t first,
                     std::size_t last) const;
    template <class Visit>
    void visit_edges(const Bounds& box, const Visit& visit) const;
    void build(std::size_t node, std::size_t first, std::size_t last);

    Ring ring_;  ///< its first point again at the end
    std::vector<Bounds> boxes_;
};

}  // namespace rockslope
