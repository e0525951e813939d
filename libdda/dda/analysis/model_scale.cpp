#include "dda/analysis/model_scale.hpp"

#include <algorithm>
#include <limits>

#include "dda/block/block_system.hpp"
#include "dda/contact/candidates.hpp"

namespace rockslope::dda {

namespace {

double extent(CornerSpan<const Vec2> vertices, int axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec2& v : vertices) {
        low = std::min(low, v[axis]);
        high = std::max(high, v[axis]);
    }
    return high - low;
}

double largest_coordinate(CornerSpan<const Vec2> vertices) {
    double largest = 0;
    for (const Vec2& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    return largest;
}

double mean_weight_of(const Model& model, const RowMap& rows) {
    if (rows.count() == 0) return 0;
    const BlockSystem blocks = initial_block_system(model);
    double mass = 0;
    for (const BlockIndex block : rows.block_of) mass += blocks.mass[block];
    return mass * model.gravity.norm() / rows.count();
}

}  // namespace

ModelScale::ModelScale(const Model& model, const RowMap& rows)
    : half_height(extent(model.vertices, 1) / 2),
      mean_weight(mean_weight_of(model, rows)),
      coordinate_rounding(8 * std::numeric_limits<double>::epsilon() * largest_coordinate(model.vertices)),
      edge_length(median_edge_length(model.topology, model.vertices)) {}

}  // namespace rockslope::dda
