#pragma once

#include "support/scene.hpp"

namespace rockslope::scene {

/// A running-bond wall of 1 m blocks on a fixed base: rows alternate between whole blocks and rows that start
/// and end with halves. Young's modulus 5 GPa, density 2600, friction 35 degrees; penalty in multiples of E.
inline Scene running_bond_wall(int columns, int rows, double penalty_over_e) {
    Scene s;
    s.model.block_materials[0] = {"rock", 2600, 5e9, 0.25, 0.1, dda::Vec3::Zero()};
    s.friction(35);
    s.model.normal_penalty = s.model.shear_penalty = penalty_over_e * 5e9;
    s.box({-1, -1}, columns + 2, 1, dda::Motion::fixed);
    for (int row = 0; row < rows; ++row) {
        if (row % 2 == 0) {
            for (int c = 0; c < columns; ++c) s.box({c, row}, 1, 1);
        } else {
            s.box({0, row}, .5, 1);
            for (int c = 0; c + 1 < columns; ++c) s.box({c + .5, row}, 1, 1);
            s.box({columns - .5, row}, .5, 1);
        }
    }
    return s;
}

}  // namespace rockslope::scene
