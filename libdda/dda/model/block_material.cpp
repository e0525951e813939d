#include "dda/model/block_material.hpp"

namespace rockslope::dda {

Mat3 elasticity(const BlockMaterial& material, Plane plane) {
    const double e = material.youngs_modulus;
    const double nu = material.poissons_ratio;
    Mat3 c = Mat3::Zero();
    if (plane == Plane::stress) {
        // Plane stress, Eq. (12).
        const double factor = e / (1 - nu * nu);
        c(0, 0) = c(1, 1) = factor;
        c(0, 1) = c(1, 0) = factor * nu;
    } else {
        // Plane strain, Eq. (13).
        const double factor = e / ((1 + nu) * (1 - 2 * nu));
        c(0, 0) = c(1, 1) = factor * (1 - nu);
        c(0, 1) = c(1, 0) = factor * nu;
    }
    c(2, 2) = e / (2 * (1 + nu));
    return c;
}

}  // namespace rockslope::dda
