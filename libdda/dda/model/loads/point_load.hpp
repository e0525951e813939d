#pragma once

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

/// A force at a material point, N per metre of thickness, times its history.
struct PointLoad {
    static constexpr const char* key = "point_load";

    PointIndex point;
    Vec2 force = Vec2::Zero();
    TimeTable history;

    template <class Table>
    static PointLoad read(Table& table) {
        return {table.point(), table.force("force"), table.history()};
    }
    template <class Forces>
    void add_to(Forces& forces) const {
        forces.add_at_point(point, forces.factor(history), force);
    }
    template <class Blocks>
    double max_acceleration(const Blocks& blocks) const {
        return force.norm() / blocks.mass(blocks.block_of(point));
    }
};

}  // namespace rockslope::dda
