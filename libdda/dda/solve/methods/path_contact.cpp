#include "dda/solve/methods/path_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockslope::dda {

namespace {

/// Bisections for the room of the shear force on the central path, and its smallest value over the width
/// between the bounds.
constexpr int bisections = 60;
constexpr double smallest_room_ratio = 1e-30;

/// The largest fraction of a change that keeps a value positive.
double largest_fraction(double value, double change) {
    return change < 0 ? -value / change : std::numeric_limits<double>::infinity();
}

}  // namespace

/// The point of Eq. (92). The smaller of two values is computed first, because the difference of large ones
/// would be rounded to zero.
void PathContact::place_on_path(double product) {
    at = {};
    at.normal = spring_normal;
    if (!bonded) {
        const double larger =
            (std::abs(spring_normal) + std::sqrt(spring_normal * spring_normal + 4 * product)) / 2;
        const double smaller = product / larger;
        at.normal = spring_normal > 0 ? larger : smaller;
        at.distance = spring_normal > 0 ? smaller : larger;
    }
    if (shear == Shear::elastic) at.shear = spring_shear;
    if (shear == Shear::bounded) place_shear_on_path(product);
}

/// The shear force of Eqs. (90) and (91) by bisection of the room to the nearer bound.
void PathContact::place_shear_on_path(double product) {
    const double forward_bound = cohesion + forward * at.normal;
    const double backward_bound = cohesion + backward * at.normal;
    const double width = forward_bound + backward_bound;
    if (!(width > 0)) {  // a bond with more tension than leaves it a shear strength
        shear = Shear::none;
        return;
    }
    const bool is_forward = spring_shear > (forward_bound - backward_bound) / 2;
    const double beyond = is_forward ? spring_shear - forward_bound : -spring_shear - backward_bound;
    double low = smallest_room_ratio * width;
    double high = width;
    double room = width;
    for (int i = 0; i < bisections; ++i) {
        room = std::sqrt(low * high);
        const double excess = product / room - product / (width - room) - room - beyond;
        (excess > 0 ? low : high) = room;
    }
    at.shear = is_forward ? forward_bound - room : room - backward_bound;
    at.forward_room = is_forward ? room : width - room;
    at.backward_room = is_forward ? width - room : room;
    at.forward_multiplier = product / at.forward_room;
    at.backward_multiplier = product / at.backward_room;
}

void PathContact::hold_bounds() {
    if (shear != Shear::bounded) return;
    const double slope = (forward + backward) / 2;
    const double tilt = (backward - forward) / 2;
    cohesion += slope * (bonded ? at.normal : std::max(at.normal, 0.0));
    forward = -tilt;
    backward = tilt;
    if (!(cohesion > 0)) shear = Shear::none;
}

/// The parts of Eq. (94).
void PathContact::set_fractions() {
    normal_fraction = bonded ? 1 : at.normal / (at.normal + at.distance);
    shear_fraction = shear == Shear::none ? 0 : 1;
    coupling = 0;
    if (shear != Shear::bounded) return;
    const double of_forward = at.forward_multiplier / at.forward_room;
    const double of_backward = at.backward_multiplier / at.backward_room;
    shear_fraction = 1 / (1 + of_forward + of_backward);
    coupling = (of_forward * forward - of_backward * backward) * shear_fraction;
}

void PathContact::set_constants() {
    normal_constant = spring_normal - at.normal;
    if (!bonded) normal_constant = normal_fraction * (spring_normal - at.normal + target.normal / at.normal);
    shear_constant = shear == Shear::none ? 0 : spring_shear - at.shear;
    if (shear == Shear::bounded) {
        shear_constant = shear_fraction * (spring_shear - at.shear - target.forward / at.forward_room +
                                           target.backward / at.backward_room);
    }
}

void PathContact::set_change(double opening_change, double shearing_change) {
    change = {};
    change.normal = normal_constant - normal_fraction * normal_stiffness * opening_change;
    if (!bonded) change.distance = (target.normal - at.distance * (at.normal + change.normal)) / at.normal;
    if (shear == Shear::none) return;
    change.shear =
        shear_constant + coupling * change.normal + shear_fraction * shear_stiffness * shearing_change;
    if (shear == Shear::elastic) return;
    change.forward_room = forward * change.normal - change.shear;
    change.backward_room = backward * change.normal + change.shear;
    change.forward_multiplier =
        (target.forward - at.forward_multiplier * (at.forward_room + change.forward_room)) / at.forward_room;
    change.backward_multiplier =
        (target.backward - at.backward_multiplier * (at.backward_room + change.backward_room)) /
        at.backward_room;
}

/// The targets of Eq. (95).
PathContact::Products PathContact::corrected_target(double product) const {
    return {product - change.normal * change.distance,
            product - change.forward_room * change.forward_multiplier,
            product - change.backward_room * change.backward_multiplier};
}

/// The products of Eq. (91).
PathContact::Products PathContact::products(double step) const {
    const auto after = [step](double value, double by) { return value + step * by; };
    return {
        after(at.normal, change.normal) * after(at.distance, change.distance),
        after(at.forward_room, change.forward_room) * after(at.forward_multiplier, change.forward_multiplier),
        after(at.backward_room, change.backward_room) *
            after(at.backward_multiplier, change.backward_multiplier)};
}

double PathContact::largest_step() const {
    double step = std::numeric_limits<double>::infinity();
    if (!bonded) {
        step = std::min(largest_fraction(at.normal, change.normal),
                        largest_fraction(at.distance, change.distance));
    }
    if (shear != Shear::bounded) return step;
    return std::min({step, largest_fraction(at.forward_room, change.forward_room),
                     largest_fraction(at.backward_room, change.backward_room),
                     largest_fraction(at.forward_multiplier, change.forward_multiplier),
                     largest_fraction(at.backward_multiplier, change.backward_multiplier)});
}

void PathContact::advance(double step) {
    at.normal += step * change.normal;
    at.distance += step * change.distance;
    at.shear += step * change.shear;
    at.forward_multiplier += step * change.forward_multiplier;
    at.forward_room += step * change.forward_room;
    at.backward_room += step * change.backward_room;
    at.backward_multiplier += step * change.backward_multiplier;
}

double PathContact::law_error() const {
    const double normal = bonded ? spring_normal : std::max(spring_normal, 0.0);
    double law_shear = shear == Shear::none ? 0 : spring_shear;
    if (shear == Shear::bounded) {
        law_shear = std::clamp(law_shear, std::min(-(cohesion + backward * normal), 0.0),
                               std::max(cohesion + forward * normal, 0.0));
    }
    return std::max(std::abs(normal - at.normal), std::abs(law_shear - at.shear));
}

}  // namespace rockslope::dda
