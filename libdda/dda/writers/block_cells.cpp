#include <algorithm>
#include <iterator>
#include <limits>

#include "dda/writers/frame_data.hpp"

namespace rockslope::dda {

namespace {

constexpr std::uint8_t vtk_polygon = 7;

struct Rings {
    const Model& model;
    const Vec2& at(CornerIndex corner) const { return model.vertices[corner]; }
    std::vector<std::int64_t> corners(RingIndex ring) const {
        std::vector<std::int64_t> result;
        for (CornerIndex c = model.topology.ring_corners[ring]; c < model.topology.ring_corners[ring + 1];
             ++c)
            result.push_back(c.value());
        return result;
    }
};

/// Whether two segments cross between their ends; segments that share an end do not cross.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double s1 = cross(b - a, c - a), s2 = cross(b - a, d - a);
    const double s3 = cross(d - c, a - c), s4 = cross(d - c, b - c);
    return ((s1 > 0) != (s2 > 0)) && ((s3 > 0) != (s4 > 0)) && s1 * s2 != 0 && s3 * s4 != 0;
}

bool is_clear(const Rings& rings, std::int64_t from, std::int64_t to,
              const std::vector<std::vector<std::int64_t>>& obstacles) {
    for (const auto& ring : obstacles)
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (cross_each_other(rings.at(from), rings.at(to), rings.at(ring[i]),
                                 rings.at(ring[(i + 1) % ring.size()])))
                return false;
    return true;
}

/// Inserts a hole into a ring by a slit along the shortest line between two corners that crosses no obstacle.
void join_hole(const Rings& rings, const std::vector<std::int64_t>& hole,
               const std::vector<std::vector<std::int64_t>>& obstacles, std::vector<std::int64_t>& ring) {
    std::size_t best_ring = 0, best_hole = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (std::size_t k = 0; k < hole.size(); ++k) {
            const double length = (rings.at(ring[i]) - rings.at(hole[k])).squaredNorm();
            if (length >= shortest || !is_clear(rings, ring[i], hole[k], obstacles)) continue;
            shortest = length;
            best_ring = i;
            best_hole = k;
        }
    }
    std::vector<std::int64_t> slit(std::next(hole.begin(), best_hole), hole.end());
    slit.insert(slit.end(), hole.begin(), std::next(hole.begin(), best_hole + 1));
    slit.push_back(ring[best_ring]);
    ring.insert(std::next(ring.begin(), best_ring + 1), slit.begin(), slit.end());
}

}  // namespace

GridCells block_cells(const Model& model) {
    GridCells cells;
    const Rings rings{model};
    for (const BlockIndex block : model.blocks()) {
        std::vector<std::vector<std::int64_t>> all;
        for (const RingIndex ring :
             indices(model.topology.block_rings[block], model.topology.block_rings[block + 1]))
            all.push_back(rings.corners(ring));
        std::vector<std::int64_t> outline = all.front();
        for (std::size_t hole = 1; hole < all.size(); ++hole) join_hole(rings, all[hole], all, outline);
        cells.add(outline, vtk_polygon);
    }
    return cells;
}

}  // namespace rockslope::dda
