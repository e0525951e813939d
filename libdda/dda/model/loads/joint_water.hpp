#pragma once

#include <vector>

#include "dda/base/indices.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

/// Water under one pressure in a set of joints, on both faces of each joint, times its history.
/// Its tractions: visit_tractions in terms/water.cpp.
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

}  // namespace rockslope::dda
