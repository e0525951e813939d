#pragma once

#include <string>

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/model/load_list.hpp"

namespace rockslope::dda {

/// A point that moves with its block.
struct MaterialPoint {
    BlockIndex block;
    Vec2 position = Vec2::Zero();  ///< m, in the initial configuration
};

// Load is the std::variant of all loads. A load is one file in model/loads and one line in loads/loads.txt;
// CMake writes load_list.hpp from it. A load has four named members.
// - key: the name of its array of tables in the model file.
// - read(table): makes it from such a table, a LoadTable of input/read_loads.cpp.
// - add_to(forces): adds its force to the blocks' unknowns, a LoadForces of terms/loads.cpp.
// - max_acceleration(blocks): largest acceleration of a block by the load, m/s2; a LoadedBlocks of the same
// file.

/// A material point tied to its initial position by springs in x and y (Shi's fixed point).
struct FixedPoint {
    PointIndex point;
    bool hold_x = true;
    bool hold_y = true;
};

/// A bar between two material points, linear elastic up to its yield force.
struct BoltSpec {
    std::string name;
    PointIndex first;
    PointIndex second;
    double axial_stiffness = 0;  ///< EA over the spacing of the bolts, N per metre of thickness
    double pretension = 0;       ///< N per metre of thickness, tension positive
    double yield_force = 0;      ///< N per metre of thickness; 0: elastic without limit
};

}  // namespace rockslope::dda
