#pragma once

#include <algorithm>
#include <cstddef>

#include "support/scene.hpp"

namespace rockslope::scene {

/// Total momentum of the blocks from index `first` on, kg m/s per metre.
inline Vec2 momentum(const dda::State& state, std::size_t first) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t b = first; b < state.blocks.mass.size(); ++b)
        sum += state.blocks.mass[b] * state.blocks.velocity[b].head<2>();
    return sum;
}

/// Compares the change of momentum of all blocks but block 0, which is fixed, with the impulses of gravity
/// and of the contacts with block 0.
class MomentumBalance {
  public:
    explicit MomentumBalance(const dda::State& start) : momentum_(momentum(start, 1)) {}

    /// Adds a step. @param step s
    void add_step(const dda::Model& model, const dda::State& after, double step) {
        Vec2 force = Vec2::Zero();
        for (std::size_t b = 1; b < after.blocks.mass.size(); ++b)
            force += after.blocks.mass[b] * model.gravity;
        for (const dda::Contact& c : after.contacts.contacts) {
            const Vec2 on_corner = c.normal_force * c.normal - c.shear_force * c.tangent;
            if (c.edge_block == 0) force += on_corner;
            if (c.corner_block == 0) force -= on_corner;
        }
        const Vec2 now = momentum(after, 1);
        unexplained_ += now - momentum_ - step * force;
        largest_unexplained_ = std::max(largest_unexplained_, unexplained_.norm());
        largest_ = std::max(largest_, now.norm());
        momentum_ = now;
    }
    /// kg m/s, the largest change of momentum so far that no force explains
    double unexplained() const { return largest_unexplained_; }
    /// kg m/s, the largest total momentum so far
    double largest() const { return largest_; }

  private:
    Vec2 momentum_;
    Vec2 unexplained_{0, 0};
    double largest_unexplained_ = 0;
    double largest_ = 0;
};

}  // namespace rockslope::scene
