#pragma once

#include <vector>

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

// Tractions of both loads: visit_tractions in terms/water.cpp.

/// Water under one pressure in a set of joints, on both faces of each joint, times its history.
struct JointWater {
    static constexpr const char* key = "joint_water";

    std::vector<EdgeIndex> edges;  ///< the wetted faces
    double pressure = 0;           ///< Pa
    TimeTable history;

    template <class Table>
    static JointWater read(Table& table) {
        return {table.wetted_joints(), table.pressure("pressure"), table.history()};
    }
    template <class Forces>
    void add_to(Forces& forces) const {
        forces.add_tractions(*this);
    }
    template <class Blocks>
    double max_acceleration(const Blocks& blocks) const {
        return blocks.max_traction_acceleration(*this);
    }
};

/// Still water below a head line: hydrostatic pressure on the wetted faces below it.
struct HeadWater {
    static constexpr const char* key = "head_water";

    std::vector<EdgeIndex> edges;  ///< the wetted faces
    std::vector<Vec2> head;        ///< m, x increasing; linear between its points, level beyond its ends
    double unit_weight = 0;        ///< N/m3, of the water
    TimeTable history;             ///< factor on the pressure

    template <class Table>
    static HeadWater read(Table& table) {
        return {table.wetted_faces(), table.head(), table.unit_weight_of_water(), table.history()};
    }
    template <class Forces>
    void add_to(Forces& forces) const {
        forces.add_tractions(*this);
    }
    template <class Blocks>
    double max_acceleration(const Blocks& blocks) const {
        return blocks.max_traction_acceleration(*this);
    }
};

}  // namespace rockslope::dda
