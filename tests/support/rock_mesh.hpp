#pragma once

#include "support/bar.hpp"

namespace rockslope::scene {

/// A rectangle of square blocks of 1 m. The joints are elastic and add a thousandth to the compliance of the
/// rock. No gravity, no damping. Waves enter through a viscous boundary at the base; the sides are free, or
/// have dashpots or free fields.
struct RockMesh {
    Scene s;
    int columns, rows;

    enum class Sides { free, dashpots, free_field };

    RockMesh(int column_count, int row_count, Sides sides) : columns(column_count), rows(row_count) {
        s.model.gravity.setZero();
        s.model.block_materials[0].damping_ratio = 0;
        s.model.joint_materials[0] = elastic_joint(1e3 * 10e9, 1e3 * 10e9);
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                s.box({static_cast<double>(column), static_cast<double>(row)}, 1, 1);
        dda::ViscousBoundary below{"below", {}, 0, 0, dda::Hold::both, {}};
        dda::ViscousBoundary left{"left", {}, 0, 0, dda::Hold::both, {}};
        dda::ViscousBoundary right{"right", {}, 0, 0, dda::Hold::both, {}};
        // Edge 0 of a box is its base, 1 its right side and 3 its left.
        for (int column = 0; column < columns; ++column) below.faces.push_back({4 * block(column, 0), 0, 1});
        for (int row = 0; row < rows; ++row) {
            left.faces.push_back({4 * block(0, row) + 3, 0, 1});
            right.faces.push_back({4 * block(columns - 1, row) + 1, 0, 1});
        }
        s.model.viscous_boundaries.push_back(below);
        if (sides == Sides::free) return;
        for (dda::ViscousBoundary& side : {std::ref(left), std::ref(right)}) {
            if (sides == Sides::free_field)
                side.free_field = dda::make_free_field(s.model, side.faces, "below", 0);
            s.model.viscous_boundaries.push_back(side);
        }
    }
    int block(int column, int row) const { return row * columns + column; }

    /// A pulse of 1 m/s along an axis that enters at the base. @param pulse its duration, s.
    dda::Stage shaken(int axis, double pulse, double duration, double step) const {
        dda::Stage stage = wave_stage(duration, step);
        const dda::TimeTable at_rest({0, 1}, {0, 0}), wave = raised_cosine(pulse);
        stage.incident_waves.push_back({"below", axis == 0 ? wave : at_rest, axis == 1 ? wave : at_rest});
        return stage;
    }
};

}  // namespace rockslope::scene
