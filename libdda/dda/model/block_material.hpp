#pragma once

#include <string>

#include "dda/base/types.hpp"

namespace rockslope::dda {

enum class Plane { strain, stress };

/// Rock between the joints: linear, isotropic.
struct BlockMaterial {
    std::string name;
    double density = 0;         ///< kg/m3, positive
    double youngs_modulus = 0;  ///< Pa, positive
    double poissons_ratio = 0;  ///< in [0, 0.5)
    /// Viscous damping of a block's strain modes, fraction of critical, Eq. (18). The frequencies of these
    /// modes are above those that a mesh of constant-strain blocks resolves. Undamped, they couple with
    /// friction and make a block creep down an incline on which it should rest. Normally 0.1; a wave 20
    /// blocks long then loses 5 % per wavelength. 0: no damping.
    double damping_ratio = 0.1;
    Vec3 initial_stress = Vec3::Zero();  ///< (sigma_x, sigma_y, tau_xy) in Pa, tension positive
};

/// Hooke's law of the plane, Eq. (12) or (13): stress = elasticity(...) * (eps_x, eps_y, gamma_xy), in Pa.
Mat3 elasticity(const BlockMaterial& material, Plane plane);

}  // namespace rockslope::dda
