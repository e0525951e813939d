#include "dda/terms/loads.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dda/model/time_table.hpp"

namespace rockslope::dda {

namespace {

/// Sums the generalised forces of loads on the free blocks at one instant, or with their histories at 1.
class LoadForces {
  public:
    /// @param time s, of the load histories; none: all histories are 1.
    LoadForces(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
               std::optional<double> time)
        : model_(model),
          rows_(rows),
          blocks_(blocks),
          mid_(mid),
          time_(time),
          forces_(rows.count(), Vec6::Zero()) {}

    double factor(const TimeTable& history) const { return time_ ? history.at(*time_) : 1; }
    /// Adds a generalised force on the six unknowns of a block.
    void add(BlockIndex block, const Vec6& force) {
        const RowIndex row = rows_.row_of[block];
        if (row.exists()) forces_[row] += force;
    }
    /// Adds a force at a material point, N per metre, times a factor.
    void add_at_point(PointIndex point, double factor, const Vec2& force) {
        const BlockIndex block = model_.material_points[point].block;
        add(block, factor * project(force, mid_.points[point] - mid_.centroid[block]));
    }
    /// Adds mass times an acceleration, m/s2, for one block, or for all blocks if `block` is none.
    void add_acceleration(BlockIndex block, const Vec2& acceleration) {
        for (const BlockIndex loaded : rows_.block_of) {
            if (block.exists() && block != loaded) continue;
            Vec6 force = Vec6::Zero();
            force.head<2>() = blocks_.mass[loaded] * acceleration;
            add(loaded, force);
        }
    }
    /// Adds the tractions of a load on faces, times its history.
    template <class FaceLoad>
    void add_tractions(const FaceLoad& load) {
        const double present_factor = factor(load.history);
        if (present_factor == 0) return;
        visit_tractions(model_, mid_, load, [&](const FacePoint& point, const Vec2& traction) {
            add(point.block, present_factor * point.weight * project(traction, point.arm));
        });
    }

    PerRow<Vec6> result() && { return std::move(forces_); }

  private:
    const Model& model_;
    const RowMap& rows_;
    const BlockSystem& blocks_;
    const MidStep& mid_;
    std::optional<double> time_;
    PerRow<Vec6> forces_;
};

/// The present place of everything, for loads apart from a step.
MidStep at_present(const BlockSystem& blocks) {
    MidStep now{blocks.vertices, blocks.points, {}};
    for (const AreaMoments& moments : blocks.moments) now.centroid.push_back(moments.centroid);
    return now;
}

/// The masses, sizes and tractions for estimating the largest acceleration by a load.
class LoadedBlocks {
  public:
    LoadedBlocks(const Model& model, const BlockSystem& blocks) : model_(model), blocks_(blocks) {}

    double mass(BlockIndex block) const { return blocks_.mass[block]; }  ///< kg per metre
    /// m, the side of a square of the block's area.
    double size(BlockIndex block) const { return std::sqrt(blocks_.moments[block].area); }
    BlockIndex block_of(PointIndex point) const { return model_.material_points[point].block; }
    /// The acceleration by the sum of the magnitudes of all tractions of a load on faces, m/s2.
    template <class FaceLoad>
    double max_traction_acceleration(const FaceLoad& load) const {
        const MidStep now = at_present(blocks_);
        PerBlock<double> total_force(blocks_.mass.size(), 0);
        visit_tractions(model_, now, load, [&](const FacePoint& point, const Vec2& traction) {
            total_force[point.block] += point.weight * traction.norm();
        });
        double largest = 0;
        for (const BlockIndex b : total_force.indices())
            largest = std::max(largest, total_force[b] / blocks_.mass[b]);
        return largest;
    }

  private:
    const Model& model_;
    const BlockSystem& blocks_;
};

}  // namespace

PerRow<Vec6> unit_load_forces(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                              const MidStep& mid, const Load& load) {
    LoadForces forces(model, rows, blocks, mid, {});
    std::visit([&](const auto& l) { l.add_to(forces); }, load);
    return std::move(forces).result();
}

PerRow<Vec6> load_forces(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                         const MidStep& mid, const LoadInstant& instant) {
    LoadForces forces(model, rows, blocks, mid, instant.time);
    for (const Load& load : model.loads) std::visit([&](const auto& l) { l.add_to(forces); }, load);
    forces.add_acceleration(BlockIndex::none(), -instant.frame_acceleration);
    return std::move(forces).result();
}

void add_loads(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
               const LoadInstant& instant, BaseSystem& base) {
    const PerRow<Vec6> forces = load_forces(model, rows, blocks, mid, instant);
    for (const RowIndex row : rows.rows()) {
        base.load[row].head<2>() += blocks.mass[rows.block_of[row]] * model.gravity;
        base.load[row] += forces[row];
    }
}

double max_load_acceleration(const Model& model, const BlockSystem& blocks) {
    double largest = 0;
    const LoadedBlocks loaded(model, blocks);
    for (const Load& load : model.loads)
        largest =
            std::max(largest, std::visit([&](const auto& l) { return l.max_acceleration(loaded); }, load));
    return largest;
}

Push largest_push(const Model& model, const BlockSystem& blocks, BlockIndex block, const Vec2& direction,
                  double time) {
    const RowMap rows(model.motion);
    const RowIndex row = rows.row_of[block];
    if (!row.exists() || model.loads.empty()) return {};
    const MidStep now = at_present(blocks);
    Push largest;
    for (const Load& load : model.loads) {
        const PerRow<Vec6> forces = unit_load_forces(model, rows, blocks, now, load);
        std::visit(
            [&](const auto& l) {
                const double along = l.history.at(time) * direction.dot(forces[row].template head<2>());
                if (along > largest.force) largest = {l.key, along};
            },
            load);
    }
    return largest;
}

}  // namespace rockslope::dda
