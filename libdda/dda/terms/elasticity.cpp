#include <cmath>

#include "dda/terms/system.hpp"

namespace rockslope::dda {

double retardation_time(const BlockMaterial& material, const AreaMoments& moments) {
    // Eq. (18), with the larger principal moment of the area.
    const double largest_moment =
        (moments.xx + moments.yy) / 2 + std::hypot((moments.xx - moments.yy) / 2, moments.xy);
    const double longest = largest_moment / moments.area;
    const double frequency = std::sqrt(material.youngs_modulus / (material.density * longest));
    return 2 * material.damping_ratio / frequency;
}

void add_elasticity(const Model& model, const RowMap& rows, const BlockSystem& blocks, double dt,
                    BaseSystem& base) {
    for (const RowIndex row : rows.rows()) {
        const BlockIndex b = rows.block_of[row];
        const BlockMaterial& material = model.material_of(b);
        const double area = blocks.moments[b].area;
        // With the mean strain rate of the step, the viscous stress never adds energy.
        const double viscous = retardation_time(material, blocks.moments[b]) / dt;
        base.stiffness[row].bottomRightCorner<3, 3>() +=
            (1 + viscous) * area * elasticity(material, model.plane);
        base.load[row].tail<3>() -= area * blocks.stress[b];
    }
}

}  // namespace rockslope::dda
