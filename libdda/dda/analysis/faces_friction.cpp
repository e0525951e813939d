#include "dda/analysis/faces_friction.hpp"

namespace dda {

namespace {

/// Of the normal force, that a strength over it goes with. @param half, @param whole that strength under half
/// of the force and under all of it.
double exponent_of(double half, double whole) {
    return half > 0 && whole > 0 ? std::log2(whole / half) : 0;
}

}  // namespace

FacesFriction::FacesFriction(const StepProblem& problem, const Crew& crew)
    : crew_(crew), strength_(problem), pairs_(strength_.count()) {}

void FacesFriction::ask(std::size_t pair, const FacesPressed& pressed) {
    const bool any = pressed.normal > 0;
    pairs_[pair].asked = any ? pressed : Pair().asked;
    pairs_[pair].over_normal_force = any ? strength_.over_normal_force(pair, pressed) : Strength{};
}

void FacesFriction::want_line(std::size_t contact) {
    const auto index = static_cast<std::size_t>(strength_.pair_of(contact));
    Pair& pair = pairs_[index];
    if (pair.has_exponents || pair.wanted) return;
    pair.wanted = true;
    wanted_.push_back(index);
}

void FacesFriction::find_exponents(std::size_t index) {
    Pair& pair = pairs_[index];
    pair.wanted = false;
    if (std::isnan(pair.asked.normal)) return;
    const Strength half =
        strength_.over_normal_force(index, {pair.asked.normal / 2, pair.asked.displacement});
    pair.forward_exponent = exponent_of(half.forward, pair.over_normal_force.forward);
    pair.backward_exponent = exponent_of(half.backward, pair.over_normal_force.backward);
    pair.has_exponents = true;
}

BoundLine FacesFriction::line(std::size_t contact, bool forward, double normal_force) const {
    const Pair& pair = pair_of(contact);
    const double ratio = forward ? pair.over_normal_force.forward : pair.over_normal_force.backward;
    const double curving = ratio * (forward ? pair.forward_exponent : pair.backward_exponent);
    return {ratio + curving, -curving * std::max(normal_force, 0.0)};
}

}  // namespace dda
