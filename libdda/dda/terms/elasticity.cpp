#include "dda/terms/system.hpp"

namespace dda {

void add_elasticity(const Model& model, const RowMap& rows, const BlockSystem& blocks, BaseSystem& base) {
    for (std::size_t row = 0; row < rows.block_of.size(); ++row) {
        const auto b = static_cast<std::size_t>(rows.block_of[row]);
        const double area = blocks.moments[b].area;
        base.stiffness[row].bottomRightCorner<3, 3>() += area * elasticity(model.material_of(rows.block_of[row]), model.plane);
        base.load[row].tail<3>() -= area * blocks.stress[b];
    }
}

}  // namespace dda
