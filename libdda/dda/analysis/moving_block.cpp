#include "dda/analysis/moving_block.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "dda/analysis/step_report.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

namespace {

bool is_free(const Model& model, const State& state, BlockIndex block) {
    return model.motion[block] == Motion::free && state.is_present(block);
}

double displacement_of(const State& state, BlockIndex block) {
    return (state.blocks.moments[block].centroid - state.stage_origin[block]).norm();
}

bool is_of(const Contact& contact, BlockIndex block) {
    return contact.corner_block == block || contact.edge_block == block;
}

/// The sliding contact of a block with the largest slip.
std::optional<Contact> slipping_contact(const State& state, BlockIndex block) {
    std::optional<Contact> largest;
    for (const Contact& contact : state.contacts.contacts) {
        if (!is_of(contact, block) || contact.state != ContactState::sliding) continue;
        if (!largest || std::abs(contact.slip) > std::abs(largest->slip)) largest = contact;
    }
    return largest;
}

std::optional<Contact> locked_contact(const State& state, BlockIndex block) {
    for (const Contact& contact : state.contacts.contacts)
        if (is_of(contact, block) && contact.state == ContactState::locked) return contact;
    return {};
}

/// Largest difference of a falling block's acceleration from gravity, over gravity.
constexpr double free_fall_tolerance = 0.01;

bool falls_freely(const Model& model, const State& state, BlockIndex block) {
    const Vec2 difference = state.blocks.acceleration[block].head<2>() - model.gravity;
    return difference.norm() <= free_fall_tolerance * model.gravity.norm();
}

/// A load pushes a block that owes it at least this share of its acceleration.
constexpr double pushing_share = 0.5;

/// The key of the load that pushes a block, or null.
const char* pushing_load(const Model& model, const State& state, BlockIndex block) {
    const Vec2 acceleration = state.blocks.acceleration[block].head<2>();
    const double norm = acceleration.norm();
    if (!(norm > 0)) return nullptr;
    const Push push = largest_push(model, state.blocks, block, acceleration / norm, state.dynamic_time);
    return push.force >= pushing_share * state.blocks.mass[block] * norm ? push.load : nullptr;
}

/// The free blocks that a condition holds for.
template <class Condition>
std::vector<BlockIndex> free_blocks(const Model& model, const State& state, const Condition& condition) {
    std::vector<BlockIndex> found;
    for (const BlockIndex block : model.blocks())
        if (is_free(model, state, block) && condition(block)) found.push_back(block);
    return found;
}

/// The block with the largest value, the first of several. @param blocks at least one.
template <class Value>
BlockIndex with_largest(std::span<const BlockIndex> blocks, const Value& value) {
    return *std::max_element(blocks.begin(), blocks.end(),
                             [&](BlockIndex a, BlockIndex b) { return value(a) < value(b); });
}

}  // namespace

std::vector<BlockIndex> moving_blocks(const Model& model, const State& state, double tolerance) {
    const double reference = reference_acceleration(model, state.blocks);
    return free_blocks(model, state, [&](BlockIndex block) {
        return !(unbalanced_force(state.blocks, block, reference) <= tolerance);
    });
}

double share_of_mass(const Model& model, const State& state, std::span<const BlockIndex> blocks) {
    double all = 0, some = 0;
    for (const BlockIndex block : model.blocks())
        if (is_free(model, state, block)) all += state.blocks.mass[block];
    for (const BlockIndex block : blocks) some += state.blocks.mass[block];
    return all > 0 ? some / all : 0;
}

bool is_at_rest(const Model& model, const State& state, const Stage& stage) {
    return share_of_mass(model, state, moving_blocks(model, state, stage.tolerance)) <= stage.moving_share;
}

MovingBlock moving_block(const Model& model, const State& state, BlockIndex block) {
    const double reference = reference_acceleration(model, state.blocks);
    return {.block = block,
            .displacement = displacement_of(state, block),
            .unbalanced = unbalanced_force(state.blocks, block, reference),
            .on = slipping_contact(state, block),
            .against = locked_contact(state, block),
            .falls_freely = falls_freely(model, state, block),
            .pushed_by = pushing_load(model, state, block)};
}

std::optional<MovingBlock> block_moved_beyond(const Model& model, const State& state, double limit,
                                              double share, double tolerance) {
    const auto displacement = [&](BlockIndex block) { return displacement_of(state, block); };
    const auto beyond =
        free_blocks(model, state, [&](BlockIndex block) { return displacement(block) > limit; });
    if (beyond.empty() || share_of_mass(model, state, beyond) <= share) return {};
    std::vector<BlockIndex> going_on = moving_blocks(model, state, tolerance);
    std::erase_if(going_on, [&](BlockIndex block) { return !(displacement(block) > limit); });
    const auto mass_then_displacement = [&](BlockIndex block) {
        return std::pair(state.blocks.mass[block], displacement(block));
    };
    return moving_block(model, state,
                        with_largest(going_on.empty() ? beyond : going_on, mass_then_displacement));
}

std::optional<MovingBlock> least_balanced_block(const Model& model, const State& state) {
    const auto unbalanced = [&](BlockIndex block) { return unbalanced_force(state.blocks, block, 1); };
    const auto blocks = free_blocks(model, state, [&](BlockIndex block) { return unbalanced(block) > 0; });
    if (blocks.empty()) return {};
    return moving_block(model, state, with_largest(blocks, unbalanced));
}

std::string describe_manner(const Model& model, const MovingBlock& moving) {
    const std::string push = moving.pushed_by ? std::string(", pushed by ") + moving.pushed_by : "";
    if (moving.on) return "along '" + model.joint_material_at(moving.on->joint_material).name + "'" + push;
    if (moving.against) {
        const BlockIndex other = moving.against->corner_block == moving.block ? moving.against->edge_block
                                                                              : moving.against->corner_block;
        return "in contact with block " + std::to_string(other.value()) + " without sliding on it" + push;
    }
    if (moving.falls_freely) return "in free fall";
    return moving.pushed_by ? "out of contact" + push : "out of contact, under its loads";
}

std::string describe(const Model& model, const State& state, const MovingBlock& moving, double tolerance) {
    const char* end = moving.unbalanced <= tolerance ? " and lies still" : " and does not stop";
    const Vec2 place = state.blocks.moments[moving.block].centroid + model.origin;
    char text[320];
    std::snprintf(
        text, sizeof text,
        "block %d at (%.6g, %.6g) has moved %.3g m %s%s; its unbalanced force is %.3g of the weight",
        moving.block.value(), place.x(), place.y(), moving.displacement,
        describe_manner(model, moving).c_str(), end, moving.unbalanced);
    return text;
}

}  // namespace rockslope::dda
