#pragma once

#include <string>

#include "dda/base/types.hpp"

namespace dda {

enum class Plane { strain, stress };

/// Rock between the joints: linear, isotropic.
struct BlockMaterial {
    std::string name;
    double density = 0;          ///< kg/m3, positive
    double youngs_modulus = 0;   ///< Pa, positive
    double poissons_ratio = 0;   ///< in [0, 0.5)
    Vec3 initial_stress = Vec3::Zero();  ///< (sigma_x, sigma_y, tau_xy) in Pa, tension positive
};

/// Hooke's law of the plane, Eq. (12) or (13): stress = elasticity(...) * (eps_x, eps_y, gamma_xy), in Pa.
Mat3 elasticity(const BlockMaterial& material, Plane plane);

}  // namespace dda
