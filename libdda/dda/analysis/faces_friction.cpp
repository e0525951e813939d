#include "dda/analysis/faces_friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {

namespace {

/// Of the normal force, that a strength over it goes with. @param half, @param whole that strength under half
/// of the force and under all of it.
double exponent_of(double half, double whole) {
    return half > 0 && whole > 0 ? std::log2(whole / half) : 0;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr FacesPressed never = {no_number, no_number};

}  // namespace

FacesFriction::FacesFriction(const StepProblem& problem, const Crew& crew)
    : crew_(crew),
      strength_(problem),
      over_normal_force_(strength_.count()),
      asked_(strength_.count(), never),
      exponents_(strength_.count()) {}

void FacesFriction::find_of(std::size_t pair, const FacesPressed& pressed, double enough) {
    FacesPressed& asked = asked_[pair];
    const double way = std::abs(pressed.displacement - asked.displacement);
    if (std::abs(pressed.normal - asked.normal) <= enough && strength_.stiffness(pair) * way <= enough)
        return;
    const bool any = pressed.normal > 0;
    asked = any ? pressed : never;
    Strength& here = over_normal_force_[pair];
    here = any ? strength_.over_normal_force(pair, pressed) : Strength{};
    Exponent& known = exponents_[pair];
    if (known.known || !any) return;
    const Strength half = strength_.over_normal_force(pair, {pressed.normal / 2, pressed.displacement});
    known = {true, exponent_of(half.forward, here.forward), exponent_of(half.backward, here.backward)};
}

BoundLine FacesFriction::line(std::size_t contact, bool forward, double normal_force) const {
    const Strength& strength = over_normal_force_[pair_of(contact)];
    const Exponent& exponent = exponents_[pair_of(contact)];
    const double ratio = forward ? strength.forward : strength.backward;
    const double curving = ratio * (forward ? exponent.forward : exponent.backward);
    return {ratio + curving, -curving * std::max(normal_force, 0.0)};
}

}  // namespace dda
