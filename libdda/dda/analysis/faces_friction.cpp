#include "dda/analysis/faces_friction.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

namespace {

/// Of the normal force, that a strength over it goes with. @param half, @param whole that strength under half
/// of the force and under all of it.
double exponent(double half, double whole) {
    return half > 0 && whole > 0 ? std::log2(whole / half) : 0;
}

}  // namespace

void FacesFriction::find_of(std::size_t pair, const FacesPressed& pressed) {
    OfPair& friction = friction_[pair];
    const bool any = pressed.normal > 0;
    friction.over_normal_force = any ? strength_.over_normal_force(pair, pressed) : Strength{};
    if (friction.curved || !any) return;
    const Strength& here = friction.over_normal_force;
    const Strength half = strength_.over_normal_force(pair, {pressed.normal / 2, pressed.displacement});
    friction.exponent = {exponent(half.forward, here.forward), exponent(half.backward, here.backward), 0};
    friction.curved = true;
}

Strength FacesFriction::bounds(std::size_t contact, double normal_force) const {
    if (!(normal_force > 0)) return {};
    const Strength& ratio = of(contact).over_normal_force;
    return {normal_force * ratio.forward, normal_force * ratio.backward, normal_force * ratio.tensile};
}

BoundLine FacesFriction::line(std::size_t contact, bool forward, double normal_force) const {
    const OfPair& friction = of(contact);
    const double ratio = forward ? friction.over_normal_force.forward : friction.over_normal_force.backward;
    const double curving = ratio * (forward ? friction.exponent.forward : friction.exponent.backward);
    return {ratio + curving, -curving * std::max(normal_force, 0.0)};
}

}  // namespace dda
