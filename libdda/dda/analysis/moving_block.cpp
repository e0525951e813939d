#include "dda/analysis/moving_block.hpp"

#include <cmath>
#include <cstdio>

#include "dda/analysis/step_report.hpp"

namespace rockslope::dda {

namespace {

bool is_free(const Model& model, const State& state, BlockIndex block) {
    return model.motion[block] == Motion::free && state.is_present(block);
}

double displacement_of(const State& state, BlockIndex block) {
    return (state.blocks.moments[block].centroid - state.stage_origin[block]).norm();
}

/// The sliding contact of a block with the largest slip.
std::optional<Contact> slipping_contact(const State& state, BlockIndex block) {
    std::optional<Contact> largest;
    for (const Contact& contact : state.contacts.contacts) {
        if (contact.corner_block != block && contact.edge_block != block) continue;
        if (contact.state != ContactState::sliding) continue;
        if (!largest || std::abs(contact.slip) > std::abs(largest->slip)) largest = contact;
    }
    return largest;
}

/// The free block with the largest value, if any value is above `least`.
template <class Value>
std::optional<MovingBlock> block_with_largest(const Model& model, const State& state, double least,
                                              const Value& value) {
    BlockIndex found = BlockIndex::none();
    for (const BlockIndex block : model.blocks()) {
        if (!is_free(model, state, block) || !(value(block) > least)) continue;
        least = value(block);
        found = block;
    }
    if (!found.exists()) return {};
    const double reference = reference_acceleration(model, state.blocks);
    return MovingBlock{.block = found,
                       .displacement = displacement_of(state, found),
                       .unbalanced = unbalanced_force(state.blocks, found, reference),
                       .on = slipping_contact(state, found)};
}

}  // namespace

std::optional<MovingBlock> block_moved_beyond(const Model& model, const State& state, double limit) {
    return block_with_largest(model, state, limit,
                              [&](BlockIndex block) { return displacement_of(state, block); });
}

std::optional<MovingBlock> least_balanced_block(const Model& model, const State& state) {
    return block_with_largest(model, state, 0,
                              [&](BlockIndex block) { return unbalanced_force(state.blocks, block, 1); });
}

std::string describe(const Model& model, const State& state, const MovingBlock& moving) {
    const Vec2 place = state.blocks.moments[moving.block].centroid + model.origin;
    std::string along = "in free fall";
    if (moving.on) along = "along '" + model.joint_material_at(moving.on->joint_material).name + "'";
    char text[256];
    std::snprintf(text, sizeof text,
                  "block %d at (%.6g, %.6g) has moved %.3g m %s and does not stop; its unbalanced force is "
                  "%.3g of the weight",
                  moving.block.value(), place.x(), place.y(), moving.displacement, along.c_str(),
                  moving.unbalanced);
    return text;
}

}  // namespace rockslope::dda
