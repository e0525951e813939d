#include <cmath>

#include "dda/terms/system.hpp"

namespace rockslope::dda {

double retardation_time(const BlockMaterial& material, const AreaMoments& moments) {
    const double largest_moment =
        (moments.xx + moments.yy) / 2 + std::hypot((moments.xx - moments.yy) / 2, moments.xy);
    const double longest = largest_moment / moments.area;
    const double frequency = std::sqrt(material.youngs_modulus / (material.density * longest));
    return 2 * material.damping_ratio / frequency;
}

void add_elasticity(const Model& model, const RowMap& rows, const BlockSystem& blocks, double dt,
                    BaseSystem& base) {
    for (std::size_t row = 0; row < rows.block_of.size(); ++row) {
        const auto b = static_cast<std::size_t>(rows.block_of[row]);
        const BlockMaterial& material = model.material_of(rows.block_of[row]);
        const double area = blocks.moments[b].area;
        // The strain rate is the step's mean: the viscous stress then only ever takes energy.
        const double viscous = retardation_time(material, blocks.moments[b]) / dt;
        base.stiffness[row].bottomRightCorner<3, 3>() +=
            (1 + viscous) * area * elasticity(material, model.plane);
        base.load[row].tail<3>() -= area * blocks.stress[b];
    }
}

}  // namespace rockslope::dda
