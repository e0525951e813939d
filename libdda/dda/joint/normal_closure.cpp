#include "dda/joint/normal_closure.hpp"

#include <cmath>

namespace dda {

namespace {

/// The share of the largest closure from which the curve goes on straight.
constexpr double straight_from = 1 - 1. / 200;

/// Force and tangent of the hyperbola over k V and k, at a share of the largest closure.
double hyperbola(double share) {
    return share / (1 - share);
}
double slope(double share) {
    return 1 / ((1 - share) * (1 - share));
}
/// Energy over k V^2.
double area_below(double share) {
    // For small shares the logarithm takes away what it is subtracted from.
    if (share < 1e-3) return share * share * (1. / 2 + share * (1. / 3 + share * (1. / 4 + share / 5)));
    return -share - std::log1p(-share);
}

}  // namespace

double NormalClosure::force(double closed) const {
    if (is_linear() || closed <= 0) return stiffness * closed;
    const double share = closed / largest_closure;
    const double unit = stiffness * largest_closure;
    if (share <= straight_from) return unit * hyperbola(share);
    return unit * (hyperbola(straight_from) + slope(straight_from) * (share - straight_from));
}

double NormalClosure::closure(double borne) const {
    if (is_linear() || borne <= 0) return borne / stiffness;
    const double load = borne / (stiffness * largest_closure);
    const double last = hyperbola(straight_from);
    if (load <= last) return largest_closure * load / (1 + load);
    return largest_closure * (straight_from + (load - last) / slope(straight_from));
}

double NormalClosure::tangent(double borne) const {
    if (is_linear() || borne <= 0) return stiffness;
    const double load = borne / (stiffness * largest_closure);
    if (load > hyperbola(straight_from)) return stiffness * slope(straight_from);
    return stiffness * (1 + load) * (1 + load);
}

double NormalClosure::energy(double borne) const {
    if (is_linear() || borne <= 0) return borne * borne / (2 * stiffness);
    const double unit = stiffness * largest_closure * largest_closure;
    const double share = closure(borne) / largest_closure;
    if (share <= straight_from) return unit * area_below(share);
    const double further = share - straight_from;
    return unit * (area_below(straight_from) +
                   further * (hyperbola(straight_from) + slope(straight_from) * further / 2));
}

}  // namespace dda
