#pragma once

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

/// A uniform acceleration added to gravity, m/s2, times its history; on one block, or on all if `block` is
/// none.
struct BodyLoad {
    static constexpr const char* key = "body_load";

    BlockIndex block = BlockIndex::none();
    Vec2 acceleration = Vec2::Zero();
    TimeTable history;

    template <class Table>
    static BodyLoad read(Table& table) {
        return {table.block_or_all(), table.acceleration("acceleration"), table.history()};
    }
    template <class Forces>
    void add_to(Forces& forces) const {
        forces.add_acceleration(block, forces.factor(history) * acceleration);
    }
    template <class Blocks>
    double max_acceleration(const Blocks&) const {
        return acceleration.norm();
    }
};

}  // namespace rockslope::dda
