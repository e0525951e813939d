#include "blockgen/cut/merge_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "blockgen/mesh/measures.hpp"

namespace rockslope::blockgen {

namespace {

/// The rings of one block, for ray casting inside it.
class BlockWithHoles {
  public:
    BlockWithHoles(const BlockMesh& mesh, BlockIndex block) {
        for (std::size_t r = 0; r < mesh.ring_count(block); ++r)
            rings_.push_back(ring_points(mesh, block, r));
    }

    /// The first point of the ray from u through v, beyond v, on the block's boundary; nothing when the ray
    /// leaves the block at v.
    std::optional<Point> end_of_extension(const Point& u, const Point& v) const {
        const double dx = v.x - u.x, dy = v.y - u.y;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Ring& ring : rings_)
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
                if (a == v || b == v) continue;
                const double ex = b.x - a.x, ey = b.y - a.y, denominator = dx * ey - dy * ex;
                if (denominator == 0) continue;
                const double t = ((a.x - v.x) * ey - (a.y - v.y) * ex) / denominator;
                const double s = ((a.x - v.x) * dy - (a.y - v.y) * dx) / denominator;
                if (t > 0 && s >= 0 && s <= 1) nearest = std::min(nearest, t);
            }
        if (!std::isfinite(nearest) || !contains({v.x + nearest / 2 * dx, v.y + nearest / 2 * dy}))
            return std::nullopt;
        return Point{v.x + nearest * dx, v.y + nearest * dy};
    }

  private:
    bool contains(const Point& p) const {
        if (side_of_ring(rings_[0], p) <= 0) return false;
        return std::all_of(rings_.begin() + 1, rings_.end(),
                           [&](const Ring& hole) { return side_of_ring(hole, p) < 0; });
    }

    std::vector<Ring> rings_;
};

bool is_island(std::span<const EdgeMark> marks) {
    return std::any_of(marks.begin(), marks.end(), [](const EdgeMark& m) { return !(m == EdgeMark{}); });
}

/// The joint of one of the two edges at corner k, extended beyond the corner.
std::optional<Trace> cut_from(const BlockMesh& mesh, const BlockWithHoles& block, const Ring& ring,
                              std::span<const EdgeMark> marks, std::size_t k) {
    const std::size_t n = ring.size(), before = (k + n - 1) % n;
    for (const auto& [edge, other] : {std::pair(before, before), std::pair(k, (k + 1) % n)}) {
        if (marks[edge] == EdgeMark{}) continue;
        const auto end = block.end_of_extension(ring[other], ring[k]);
        if (!end) continue;
        return Trace{"island cut", mesh.joint_materials[marks[edge].joint_material], {ring[k], *end}};
    }
    return std::nullopt;
}

}  // namespace

std::vector<Trace> island_cuts(const BlockMesh& mesh) {
    std::vector<Trace> cuts;
    const auto before = [](const Point& p, const Point& q) {
        return std::tuple(p.x, p.y) < std::tuple(q.x, q.y);
    };
    for (const BlockIndex b : mesh.blocks()) {
        if (mesh.ring_count(b) == 1) continue;
        const BlockWithHoles block(mesh, b);
        for (std::size_t r = 1; r < mesh.ring_count(b); ++r) {
            const auto marks = mesh.ring_marks(b, r);
            if (!is_island(marks)) continue;
            const Ring ring = ring_points(mesh, b, r);
            const auto [first, last] = std::minmax_element(ring.begin(), ring.end(), before);
            for (const auto& corner : {first, last})
                if (auto cut = cut_from(mesh, block, ring, marks, corner - ring.begin()))
                    cuts.push_back(std::move(*cut));
        }
    }
    return cuts;
}

}  // namespace rockslope::blockgen
