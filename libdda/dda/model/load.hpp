#pragma once

#include <string>
#include <variant>
#include <vector>

#include "dda/base/types.hpp"
#include "dda/model/face.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

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

/// A part of a face under a load that varies linearly along it, from `from` to `to` of the face.
struct LoadedFace {
    FacePart face;
    double pressure_from = 0;           ///< Pa, into the rock positive; turns with the face
    double pressure_to = 0;             ///< Pa
    Vec2 traction_from = Vec2::Zero();  ///< Pa, in fixed directions
    Vec2 traction_to = Vec2::Zero();    ///< Pa
};

/// A load along a line of faces, times its history.
struct LineLoad {
    std::vector<LoadedFace> faces;
    TimeTable history;
};

/// Water under the same pressure everywhere in some joints, on both faces of each, times its history.
struct JointWater {
    std::vector<int> edges;  ///< the wetted faces, by their first corners
    double pressure = 0;     ///< Pa
    TimeTable history;
};

/// Still water below a head line: where a wetted face lies below it, pressure grows with the depth.
struct HeadWater {
    std::vector<int> edges;  ///< the wetted faces, by their first corners
    std::vector<Vec2> head;  ///< m, x increasing; linear between its points, level beyond its ends
    double unit_weight = 0;  ///< N/m3, of the water
    TimeTable history;       ///< factor on the pressure
};

/// The list of loads: a new load is one struct here, one file in dda/terms and one word in this list.
using Load = std::variant<PointLoad, BodyLoad, LineLoad, JointWater, HeadWater>;

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

}  // namespace rockslope::dda
