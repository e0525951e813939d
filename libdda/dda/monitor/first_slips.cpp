#include "dda/monitor/first_slips.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rockslope::dda {

namespace {

/// The closed contacts between two blocks.
struct Pair {
    BlockIndex first, second;
    bool is_locked = false;  ///< one of the contacts is locked
    bool slides = false;     ///< one of the contacts slides
    double slip = 0;         ///< m, largest of the contacts
    JointMaterialIndex joint_material = JointMaterialIndex::none();

    friend bool operator<(const Pair& a, const Pair& b) {
        return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    }
    bool is_same(const Pair& other) const { return first == other.first && second == other.second; }
    void add(const Pair& other) {
        is_locked = is_locked || other.is_locked;
        slides = slides || other.slides;
        if (other.slip > slip) joint_material = other.joint_material;
        slip = std::max(slip, other.slip);
    }
};

std::vector<Pair> closed_pairs(const State& state) {
    std::vector<Pair> single;
    for (const Contact& contact : state.contacts.contacts) {
        if (contact.state == ContactState::open) continue;
        const auto [first, second] = std::minmax(contact.corner_block, contact.edge_block);
        const bool slides = contact.state == ContactState::sliding;
        single.push_back({first, second, !slides, slides, std::abs(contact.slip), contact.joint_material});
    }
    std::stable_sort(single.begin(), single.end());
    std::vector<Pair> pairs;
    for (const Pair& pair : single) {
        if (!pairs.empty() && pairs.back().is_same(pair))
            pairs.back().add(pair);
        else
            pairs.push_back(pair);
    }
    return pairs;
}

/// The block on which a block slides in a step.
struct Sliding {
    bool slides = false;
    double slip = 0;  ///< m, largest of the contacts
    BlockIndex other = BlockIndex::none();
    JointMaterialIndex joint_material = JointMaterialIndex::none();

    void add(const Pair& pair, BlockIndex with) {
        if (slides && pair.slip <= slip) return;
        *this = {true, pair.slip, with, pair.joint_material};
    }
};

PerBlock<Sliding> sliding_of(const Model& model, const State& state) {
    PerBlock<Sliding> blocks(model.block_count());
    for (const Pair& pair : closed_pairs(state)) {
        if (!pair.slides || pair.is_locked) continue;
        blocks[pair.first].add(pair, pair.second);
        blocks[pair.second].add(pair, pair.first);
    }
    return blocks;
}

}  // namespace

void update_first_slips(const Model& model, const State& state, const StepReport& step, double threshold,
                        PerBlock<FirstSlip>& slips) {
    const std::vector<Sliding> blocks = sliding_of(model, state);
    for (const BlockIndex b : slips.indices()) {
        FirstSlip& slip = slips[b];
        const Sliding& now = blocks[b];
        if (slip.has_slipped() || model.motion[b] != Motion::free) continue;
        if (!now.slides) {
            slip.sliding_since = -1;
            continue;
        }
        if (slip.sliding_since < 0) slip.sliding_since = std::max(state.dynamic_time - step.step, 0.0);
        if (now.slip <= threshold) continue;
        slip.dynamic_time = slip.sliding_since;
        slip.time = state.time - (state.dynamic_time - slip.sliding_since);
        slip.other = now.other;
        slip.joint_material = now.joint_material;
    }
}

}  // namespace rockslope::dda
