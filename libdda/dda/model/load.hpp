#pragma once

#include <string>
#include <variant>
#include <vector>

#include "dda/base/types.hpp"
#include "dda/model/time_table.hpp"

namespace dda {

/// A point that moves with its block.
struct MaterialPoint {
    int block = 0;
    Vec2 position = Vec2::Zero();  ///< m, in the initial configuration
};

/// A force at a material point, N per metre of thickness, times its history.
struct PointLoad {
    int point = 0;  ///< index into Model::material_points
    Vec2 force = Vec2::Zero();
    TimeTable history;
};

/// A uniform acceleration field added to gravity, m/s2, times its history; on one block, or on all when block
/// < 0.
struct BodyLoad {
    int block = -1;
    Vec2 acceleration = Vec2::Zero();
    TimeTable history;
};

/// The list of loads: a new load is one struct here, one file in dda/terms and one word in this list.
using Load = std::variant<PointLoad, BodyLoad>;

/// A material point held by springs in x and y at where it was (Shi's fixed point).
struct FixedPoint {
    int point = 0;  ///< index into Model::material_points
    bool hold_x = true;
    bool hold_y = true;
};

/// A bar between two material points, linear elastic up to its yield force.
struct BoltSpec {
    std::string name;
    int first = 0;               ///< index into Model::material_points
    int second = 0;              ///< likewise
    double axial_stiffness = 0;  ///< EA over the spacing of the bolts, N per metre of thickness
    double pretension = 0;       ///< N per metre of thickness, tension positive
    double yield_force = 0;      ///< N per metre of thickness; 0: elastic without limit
};

}  // namespace dda
