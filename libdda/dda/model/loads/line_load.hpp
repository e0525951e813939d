#pragma once

#include <vector>

#include "dda/base/types.hpp"
#include "dda/model/face.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

/// A part of a face under a load that varies linearly between the ends `from` and `to` of the part.
struct LoadedFace {
    FacePart face;
    double pressure_from = 0;           ///< Pa, positive into the rock; normal to the deformed face
    double pressure_to = 0;             ///< Pa
    Vec2 traction_from = Vec2::Zero();  ///< Pa, in fixed directions
    Vec2 traction_to = Vec2::Zero();    ///< Pa
};

/// A load along a line of faces, times its history. Tractions: visit_tractions in terms/line_load.cpp.
struct LineLoad {
    static constexpr const char* key = "line_load";

    std::vector<LoadedFace> faces;
    TimeTable history;

    template <class Table>
    static LineLoad read(Table& table) {
        return table.line_load();
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
