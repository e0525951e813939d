#include "dda/joint/normal_closure.hpp"

#include <cmath>

namespace rockslope::dda {

namespace {

/// Fraction of the largest closure above which the curve is straight.
constexpr double linear_from = 1 - 1. / 200;

/// Force and tangent of the hyperbola, Eq. (44), over k V and k, at a share of the largest closure.
double hyperbola(double share) {
    return share / (1 - share);
}
double slope(double share) {
    return 1 / ((1 - share) * (1 - share));
}
/// Energy over k V^2.
double hyperbola_energy(double share) {
    // For small fractions the two terms cancel: series.
    if (share < 1e-3) return share * share * (1. / 2 + share * (1. / 3 + share * (1. / 4 + share / 5)));
    return -share - std::log1p(-share);
}

}  // namespace

/// Eq. (44).
double NormalClosure::force(double closed) const {
    if (is_linear() || closed <= 0) return stiffness * closed;
    const double share = closed / largest_closure;
    const double unit = stiffness * largest_closure;
    if (share <= linear_from) return unit * hyperbola(share);
    return unit * (hyperbola(linear_from) + slope(linear_from) * (share - linear_from));
}

double NormalClosure::closure(double borne) const {
    if (is_linear() || borne <= 0) return borne / stiffness;
    const double load = borne / (stiffness * largest_closure);
    const double last = hyperbola(linear_from);
    if (load <= last) return largest_closure * load / (1 + load);
    return largest_closure * (linear_from + (load - last) / slope(linear_from));
}

double NormalClosure::tangent(double borne) const {
    if (is_linear() || borne <= 0) return stiffness;
    const double load = borne / (stiffness * largest_closure);
    if (load > hyperbola(linear_from)) return stiffness * slope(linear_from);
    return stiffness * (1 + load) * (1 + load);
}

double NormalClosure::energy(double borne) const {
    if (is_linear() || borne <= 0) return borne * borne / (2 * stiffness);
    const double unit = stiffness * largest_closure * largest_closure;
    const double share = closure(borne) / largest_closure;
    if (share <= linear_from) return unit * hyperbola_energy(share);
    const double further = share - linear_from;
    return unit * (hyperbola_energy(linear_from) +
                   further * (hyperbola(linear_from) + slope(linear_from) * further / 2));
}

}  // namespace rockslope::dda
