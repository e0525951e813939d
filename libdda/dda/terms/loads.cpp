#include "dda/terms/system.hpp"

namespace dda {

namespace {

struct LoadOnBlock {
    const Model& model;
    int block;
    const BlockSystem& blocks;
    const MidStep& mid;
    double time;

    Vec6 operator()(const PointLoad& load) const {
        const auto p = static_cast<std::size_t>(load.point);
        if (model.material_points[p].block != block) return Vec6::Zero();
        const Vec2 arm = mid.points[p] - mid.centroid[static_cast<std::size_t>(block)];
        return load.history.at(time) * project(load.force, arm);
    }
    Vec6 operator()(const BodyLoad& load) const {
        Vec6 force = Vec6::Zero();
        if (load.block < 0 || load.block == block) {
            force.head<2>() =
                blocks.mass[static_cast<std::size_t>(block)] * load.history.at(time) * load.acceleration;
        }
        return force;
    }
};

}  // namespace

Vec6 load_on_block(const Model& model, int block, const BlockSystem& blocks, const MidStep& mid,
                   double time) {
    Vec6 sum = Vec6::Zero();
    for (const Load& load : model.loads)
        sum += std::visit(LoadOnBlock{model, block, blocks, mid, time}, load);
    return sum;
}

void add_loads(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
               const StepTimes& times, BaseSystem& base) {
    for (std::size_t row = 0; row < rows.block_of.size(); ++row) {
        const int block = rows.block_of[row];
        base.load[row].head<2>() += blocks.mass[static_cast<std::size_t>(block)] * model.gravity;
        if (!model.loads.empty()) base.load[row] += load_on_block(model, block, blocks, mid, times.end);
    }
}

}  // namespace dda
