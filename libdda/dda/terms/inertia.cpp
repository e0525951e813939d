#include "dda/terms/system.hpp"

namespace rockslope::dda {

Mat6 mass_matrix(double mass, const AreaMoments& moments) {
    // Eq. (11). First moments vanish about the centroid, so translation is not coupled to the other unknowns.
    const double density = mass / moments.area;
    const double xx = density * moments.xx;
    const double yy = density * moments.yy;
    const double xy = density * moments.xy;
    Mat6 m = Mat6::Zero();
    m(0, 0) = m(1, 1) = mass;
    m(2, 2) = xx + yy;
    m(2, 3) = m(3, 2) = -xy;
    m(2, 4) = m(4, 2) = xy;
    m(2, 5) = m(5, 2) = (xx - yy) / 2;
    m(3, 3) = xx;
    m(4, 4) = yy;
    m(3, 5) = m(5, 3) = xy / 2;
    m(4, 5) = m(5, 4) = xy / 2;
    m(5, 5) = (xx + yy) / 4;
    return m;
}

void add_inertia(const RowMap& rows, const BlockSystem& blocks, const Newmark& newmark, double mass_damping,
                 BaseSystem& base) {
    const double beta = newmark.beta;
    const double dt = newmark.dt;
    for (const RowIndex row : rows.rows()) {
        const BlockIndex b = rows.block_of[row];
        const Mat6 m = mass_matrix(blocks.mass[b], blocks.moments[b]);
        const Vec6& v0 = blocks.velocity[b];
        const Vec6& a0 = blocks.acceleration[b];
        base.stiffness[row] += m / (beta * dt * dt);
        base.load[row] += m * (v0 / (beta * dt) + (0.5 - beta) / beta * a0);
        if (mass_damping == 0) continue;
        base.stiffness[row] += mass_damping * newmark.velocity_rate() * m;
        base.load[row] -= mass_damping * (m * newmark.velocity_at_zero_displacement(v0, a0));
    }
}

}  // namespace rockslope::dda
