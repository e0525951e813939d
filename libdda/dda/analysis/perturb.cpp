#include "dda/analysis/perturb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockslope::dda {

namespace {

/// The next number of a splitmix64 generator, in [-1, 1).
double draw(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30u)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27u)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31u;
    return static_cast<double>(bits >> 11u) * 0x1p-52 - 1;
}

double largest_coordinate(const BlockSystem& blocks) {
    double largest = 0;
    for (const Vec2& vertex : blocks.vertices)
        largest = std::max({largest, std::abs(vertex.x()), std::abs(vertex.y())});
    return largest;
}

}  // namespace

void perturb(const Model& model, const Stage& stage, State& state) {
    if (stage.perturbation == 0) return;
    auto generator = static_cast<std::uint64_t>(stage.perturbation);
    const double speed =
        std::numeric_limits<double>::epsilon() * largest_coordinate(state.blocks) / stage.control.step;
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free || !state.is_present(block)) continue;
        state.blocks.velocity[block][0] += speed * draw(generator);
        state.blocks.velocity[block][1] += speed * draw(generator);
    }
}

}  // namespace rockslope::dda
