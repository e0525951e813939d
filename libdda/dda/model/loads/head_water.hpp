#pragma once

#include <vector>

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

/// Still water below a head line: hydrostatic pressure on the wetted faces below it.
/// Its tractions: visit_tractions in terms/water.cpp.
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
