#include "dda/geometry/simplex.hpp"

namespace rockslope::dda {

AreaMoments integrate(std::span<const Vec2> vertices, std::span<const CornerIndex> ring_ends) {
    const Vec2& apex = vertices[0];
    double area = 0;
    Vec2 first = Vec2::Zero();
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (std::size_t ring = 0; ring + 1 < ring_ends.size(); ++ring) {
        const std::size_t start = ring_ends[ring] - ring_ends[0];
        const std::size_t end = ring_ends[ring + 1] - ring_ends[0];
        for (std::size_t k = start; k < end; ++k) {
            const Vec2 p = vertices[k] - apex;
            const Vec2 q = vertices[k + 1 < end ? k + 1 : start] - apex;
            const double jacobian = cross(p, q);  // twice the signed area of the simplex
            // The edge's contributions, Eq. (5).
            area += jacobian / 2;
            first += jacobian / 6 * (p + q);
            xx += jacobian / 12 * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
            yy += jacobian / 12 * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
            xy += jacobian / 24 * (2 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2 * q.x() * q.y());
        }
    }
    const Vec2 c = first / area;
    return {area, apex + c, xx - area * c.x() * c.x(), yy - area * c.y() * c.y(), xy - area * c.x() * c.y()};
}

}  // namespace rockslope::dda
