#include "dda/terms/system.hpp"

namespace rockslope::dda {

void add_fixed_points(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
                      BaseSystem& base) {
    for (const FixedPoint& fixed : model.fixed_points) {
        const auto p = static_cast<std::size_t>(fixed.point);
        const MaterialPoint& point = model.material_points[p];
        const int row = rows.row_of[static_cast<std::size_t>(point.block)];
        if (row < 0) continue;
        const auto r = static_cast<std::size_t>(row);
        const Vec2 arm = mid.points[p] - mid.centroid[static_cast<std::size_t>(point.block)];
        const Vec2 offset = blocks.points[p] - point.position;
        for (const int axis : {0, 1}) {
            if (!(axis == 0 ? fixed.hold_x : fixed.hold_y)) continue;
            const Vec6 h = project(Vec2::Unit(axis), arm);
            base.stiffness[r] += model.fixed_point_penalty * h * h.transpose();
            base.load[r] -= model.fixed_point_penalty * offset[axis] * h;
        }
    }
}

}  // namespace rockslope::dda
