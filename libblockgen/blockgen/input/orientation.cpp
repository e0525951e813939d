#include "blockgen/input/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rockslope::blockgen {

namespace {

double dot(const Pole& a, const Pole& b) {
    return a.x * b.x + a.up * b.up + a.out * b.out;
}

Pole scaled(const Pole& p, double factor) {
    return {factor * p.x, factor * p.up, factor * p.out};
}

Pole sum(const Pole& a, const Pole& b) {
    return {a.x + b.x, a.up + b.up, a.out + b.out};
}

Pole unit(const Pole& p) {
    return scaled(p, 1 / std::sqrt(dot(p, p)));
}

/// Mean of axes (poles without sign): the direction with the largest sum of squared projections, by power
/// iteration from the first pole.
Pole mean_pole(const std::vector<Pole>& poles, bool weighted_by_section) {
    Pole mean = poles.front();
    for (int round = 0; round < 200; ++round) {
        Pole next{0, 0, 0};
        for (const Pole& p : poles)
            next = sum(next, scaled(p, dot(p, mean) * (weighted_by_section ? section_chance(p) : 1)));
        mean = unit(next);
    }
    return mean;
}

Pole fisher_pole(const Pole& mean, double k, double u, double v) {
    const double cosine = std::clamp(1 + std::log1p(u * std::expm1(-2 * k)) / k, -1.0, 1.0);
    const double sine = std::sqrt(1 - cosine * cosine), turn = 2 * std::numbers::pi * v;
    // Two unit vectors perpendicular to the mean pole, built from a coordinate axis far from it.
    const Pole axis = std::abs(mean.x) < 0.6 ? Pole{1, 0, 0} : Pole{0, 1, 0};
    const Pole first = unit(sum(axis, scaled(mean, -dot(axis, mean))));
    const Pole second{mean.up * first.out - mean.out * first.up, mean.out * first.x - mean.x * first.out,
                      mean.x * first.up - mean.up * first.x};
    return sum(scaled(mean, cosine),
               sum(scaled(first, sine * std::cos(turn)), scaled(second, sine * std::sin(turn))));
}

}  // namespace

double trace_angle(const Pole& pole) {
    return std::atan2(-pole.x, pole.up);
}

double section_chance(const Pole& pole) {
    return std::hypot(pole.x, pole.up);
}

Pole pole_of(double dip, double dip_direction, double azimuth) {
    const double turn = dip_direction - azimuth;
    return {std::sin(dip) * std::cos(turn), std::cos(dip), -std::sin(dip) * std::sin(turn)};
}

PlaneAngles plane_of(const Pole& pole, double azimuth) {
    const double sign = pole.up < 0 ? -1 : 1;
    const double dip = std::atan2(std::hypot(pole.x, pole.out), sign * pole.up);
    const double direction =
        std::remainder(std::atan2(-sign * pole.out, sign * pole.x) + azimuth, 2 * std::numbers::pi);
    return {dip, direction < 0 ? direction + 2 * std::numbers::pi : direction};
}

bool Orientation::has_scatter() const {
    return poles.empty() ? angle.law != Law::constant : poles.size() > 1 || fisher_k > 0;
}

double Orientation::mean_angle() const {
    return poles.empty() ? angle.untruncated_mean() : trace_angle(mean_pole(poles, weighted_by_section));
}

double Orientation::max_deviation_tangent() const {
    constexpr double rare = 1e-4, limit = 89 * std::numbers::pi / 180;
    const double mean = mean_angle();
    double turn = 0;
    if (poles.empty())
        turn = std::max(mean - angle.quantile(rare / 2), angle.quantile(1 - rare / 2) - mean);
    else if (poles.size() > 1)
        for (const Pole& p : poles)
            turn = std::max(turn, std::abs(std::remainder(trace_angle(p) - mean, std::numbers::pi)));
    else if (fisher_k > 0) {
        // A cone of half-angle theta about a pole at the angle beta to the section projects into the section
        // within asin(sin theta / cos beta), and in all directions when it contains the section's normal.
        const double cosine = std::max(1 + std::log(rare) / fisher_k, 0.0);
        const double projected = std::sqrt(1 - cosine * cosine) / std::hypot(poles[0].x, poles[0].up);
        turn = projected < 1 ? std::asin(projected) : limit;
    }
    return std::tan(std::min(turn, limit));
}

double Orientation::spacing_factor() const {
    if (poles.empty()) return 1;
    const Pole mean = mean_pole(poles, weighted_by_section);
    const double in_section = std::hypot(mean.x, mean.up);
    return in_section > 1e-9 ? 1 / in_section : std::numeric_limits<double>::infinity();
}

double Orientation::draw(double u, double v) const {
    return poles.empty() ? angle.quantile(u) : trace_angle(draw_pole(u, v));
}

Pole Orientation::draw_pole(double u, double v) const {
    if (poles.size() > 1) {
        const auto row = static_cast<std::size_t>(u * static_cast<double>(poles.size()));
        return poles[std::min(row, poles.size() - 1)];
    }
    return fisher_k > 0 ? fisher_pole(poles[0], fisher_k, u, v) : poles[0];
}

}  // namespace rockslope::blockgen
