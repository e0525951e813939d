#include "dda/analysis/stop_limit.hpp"

#include <cstdio>

#include "dda/analysis/moving_block.hpp"

namespace rockslope::dda {

namespace {

Vec2 displacement_so_far(const State& state, PointIndex point) {
    return state.blocks.points[point] - state.displacement_origin[point];
}

Vec2 displacement_so_far(const State& state, BlockIndex block) {
    return state.blocks.centroid(block) - state.centroid_origin[block];
}

Vec2 reference_displacement(const StopLimit& stop, const State& state) {
    if (stop.reference_point.exists()) return displacement_so_far(state, stop.reference_point);
    if (stop.reference_block.exists()) return displacement_so_far(state, stop.reference_block);
    return Vec2::Zero();
}

/// Keeps the farthest of the blocks that have moved beyond the limit.
class Farthest {
  public:
    Farthest(const Model& model, const StopLimit& stop, const State& state)
        : model_(model), state_(state), reference_(reference_displacement(stop, state)) {
        found_.displacement = found_.limit = stop.displacement;
        found_.time = state.time;
    }
    void look_at(BlockIndex block) {
        if (model_.motion[block] != Motion::free || !state_.is_present(block)) return;
        keep(block, displacement_so_far(state_, block), state_.blocks.centroid(block));
    }
    void look_at(const std::string& name, PointIndex point) {
        const BlockIndex block = model_.material_points[point].block;
        if (!state_.is_present(block)) return;
        found_.point = name;
        keep(block, displacement_so_far(state_, point), state_.blocks.points[point]);
    }
    /// @param share of the mass of the free blocks that the blocks beyond the limit must exceed.
    std::optional<Collapse> found(double share) const {
        if (!(found_.displacement > found_.limit)) return std::nullopt;
        if (found_.point.empty() && !(share_of_mass(model_, state_, beyond_) > share)) return std::nullopt;
        return found_;
    }

  private:
    void keep(BlockIndex block, const Vec2& moved, const Vec2& place) {
        const double distance = (moved - reference_).norm();
        if (distance > found_.limit) beyond_.push_back(block);
        if (!(distance > found_.displacement)) return;
        found_.block = block;
        found_.displacement = distance;
        found_.at = place + model_.origin;
    }

    const Model& model_;
    const State& state_;
    const Vec2 reference_;
    Collapse found_;
    std::vector<BlockIndex> beyond_;  ///< blocks that have moved beyond the limit
};

}  // namespace

std::optional<Collapse> find_collapse(const Model& model, const Stage& stage, const State& state) {
    if (!stage.stop) return std::nullopt;
    const StopLimit& stop = *stage.stop;
    Farthest farthest(model, stop, state);
    if (stop.point.exists()) {
        farthest.look_at(stop.watched, stop.point);
    } else if (!stop.watched.empty()) {
        for (const BlockIndex block : stop.blocks) farthest.look_at(block);
    } else {
        for (const BlockIndex block : model.blocks()) farthest.look_at(block);
    }
    return farthest.found(stop.share);
}

std::string describe(const Model& model, const Stage& stage, const State& state, const Collapse& collapse) {
    const std::string what = collapse.point.empty() ? "block " + std::to_string(collapse.block.value())
                                                    : "point '" + collapse.point + "' of block " +
                                                          std::to_string(collapse.block.value());
    const bool is_static = stage.is_static();
    const char* goes_on = is_static && is_at_rest(model, state, stage) ? "" : ", and does not stop";
    char text[400];
    std::snprintf(text, sizeof text,
                  "stage '%s' has collapsed, t = %.6g s: %s at (%.6g, %.6g) has moved %.3g m %s, beyond the "
                  "limit of %g m%s",
                  stage.name.c_str(), collapse.time, what.c_str(), collapse.at.x(), collapse.at.y(),
                  collapse.displacement,
                  describe_manner(model, moving_block(model, state, collapse.block)).c_str(), collapse.limit,
                  goes_on);
    return text;
}

}  // namespace rockslope::dda
