#include "dda/terms/loads.hpp"

#include <algorithm>

namespace rockslope::dda {

namespace {

/// Adds one load's force at an instant to the rows.
struct AddLoad {
    const Model& model;
    const RowMap& rows;
    const BlockSystem& blocks;
    const MidStep& mid;
    double time;
    std::vector<Vec6>& forces;

    void operator()(const PointLoad& load) const {
        const auto p = static_cast<std::size_t>(load.point);
        const int block = model.material_points[p].block;
        add(block, load.history.at(time) *
                       project(load.force, mid.points[p] - mid.centroid[static_cast<std::size_t>(block)]));
    }
    void operator()(const BodyLoad& load) const {
        const Vec2 acceleration = load.history.at(time) * load.acceleration;
        for (const int block : rows.block_of) {
            if (load.block >= 0 && load.block != block) continue;
            Vec6 force = Vec6::Zero();
            force.head<2>() = blocks.mass[static_cast<std::size_t>(block)] * acceleration;
            add(block, force);
        }
    }
    template <class FaceLoad>
    void operator()(const FaceLoad& load) const {
        const double factor = load.history.at(time);
        if (factor == 0) return;
        visit_tractions(model, mid, load, [&](const FacePoint& point, const Vec2& traction) {
            add(point.block, factor * point.weight * project(traction, point.arm));
        });
    }

    void add(int block, const Vec6& force) const {
        const int row = rows.row_of[static_cast<std::size_t>(block)];
        if (row >= 0) forces[static_cast<std::size_t>(row)] += force;
    }
};

/// The largest acceleration by one load.
struct MaxLoadAcceleration {
    const Model& model;
    const BlockSystem& blocks;

    double operator()(const PointLoad& load) const {
        const int block = model.material_points[static_cast<std::size_t>(load.point)].block;
        return load.force.norm() / blocks.mass[static_cast<std::size_t>(block)];
    }
    double operator()(const BodyLoad& load) const { return load.acceleration.norm(); }
    template <class FaceLoad>
    double operator()(const FaceLoad& load) const {
        MidStep now{blocks.vertices, blocks.points, {}};
        for (const AreaMoments& moments : blocks.moments) now.centroid.push_back(moments.centroid);
        std::vector<double> total_force(blocks.mass.size(), 0);
        visit_tractions(model, now, load, [&](const FacePoint& point, const Vec2& traction) {
            total_force[static_cast<std::size_t>(point.block)] += point.weight * traction.norm();
        });
        double largest = 0;
        for (std::size_t b = 0; b < total_force.size(); ++b)
            largest = std::max(largest, total_force[b] / blocks.mass[b]);
        return largest;
    }
};

}  // namespace

std::vector<Vec6> load_forces(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                              const MidStep& mid, const LoadInstant& instant) {
    std::vector<Vec6> forces(static_cast<std::size_t>(rows.count()), Vec6::Zero());
    const AddLoad add{model, rows, blocks, mid, instant.time, forces};
    for (const Load& load : model.loads) std::visit(add, load);
    add(BodyLoad{-1, -instant.frame_acceleration, {}});
    return forces;
}

void add_loads(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
               const LoadInstant& instant, BaseSystem& base) {
    const std::vector<Vec6> forces = load_forces(model, rows, blocks, mid, instant);
    for (std::size_t row = 0; row < rows.block_of.size(); ++row) {
        const auto b = static_cast<std::size_t>(rows.block_of[row]);
        base.load[row].head<2>() += blocks.mass[b] * model.gravity;
        base.load[row] += forces[row];
    }
}

double max_load_acceleration(const Model& model, const BlockSystem& blocks) {
    double largest = 0;
    for (const Load& load : model.loads)
        largest = std::max(largest, std::visit(MaxLoadAcceleration{model, blocks}, load));
    return largest;
}

}  // namespace rockslope::dda
