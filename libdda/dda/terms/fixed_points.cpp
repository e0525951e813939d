#include "dda/terms/system.hpp"

namespace rockslope::dda {

void add_fixed_points(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
                      BaseSystem& base) {
    for (const FixedPoint& fixed : model.fixed_points) {
        const PointIndex p = fixed.point;
        const MaterialPoint& point = model.material_points[p];
        const RowIndex row = rows.row_of[point.block];
        if (!row.exists()) continue;
        const Vec2 arm = mid.points[p] - mid.centroid[point.block];
        const Vec2 offset = blocks.points[p] - point.position;
        for (const int axis : {0, 1}) {
            if (!(axis == 0 ? fixed.hold_x : fixed.hold_y)) continue;
            const Vec6 h = project(Vec2::Unit(axis), arm);
            // The spring of Eq. (39).
            base.stiffness[row] += model.fixed_point_penalty * h * h.transpose();
            base.load[row] -= model.fixed_point_penalty * offset[axis] * h;
        }
    }
}

}  // namespace rockslope::dda
