#include "dda/joint/linear_angle.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

double mean_tangent(double first, double last) {
    // Eq. (61): the integral of tan is -ln cos, and
    // cos(m + h) / cos(m - h) = (1 - tan m tan h) / (1 + tan m tan h).
    const double middle = (first + last) / 2, half = (last - first) / 2;
    const double tangent = std::tan(middle);
    return std::abs(half) < 1e-8 ? tangent : std::atanh(tangent * std::tan(half)) / half;
}

/// The dilation of Eq. (79).
double dilation_before_slip(const LinearAngle& piece, double start, double climb) {
    const auto is_limited = [&](double along) {
        return std::tan(piece.angle_at(along)) > climb * (start + along);
    };
    const auto integral = [&](double from, double to) {
        if (is_limited((from + to) / 2)) return climb * (to - from) * (start + (from + to) / 2);
        const double first = piece.angle_at(from), last = piece.angle_at(to);
        if (first <= 0 && last <= 0) return 0.0;
        double length = to - from;
        if (first < 0 || last < 0) length *= std::max(first, last) / std::abs(last - first);
        return length * mean_tangent(std::max(first, 0.0), std::max(last, 0.0));
    };
    if (is_limited(0) == is_limited(piece.length)) return integral(0, piece.length);
    // Where the limit begins or ends, to rounding.
    double middle = 0;
    for (double width = piece.length / 2; piece.length + width > piece.length; width /= 2)
        if (is_limited(middle + width) == is_limited(0)) middle += width;
    return integral(0, middle) + integral(middle, piece.length);
}

namespace {

/// Shortest part of a piece, relative to its length; shorter ones are rounding. A piece that begins at a
/// limit must not be cut there again.
constexpr double shortest_fraction = 1e-12;

}  // namespace

LinearAngle clamp_leading_part(const LinearAngle& piece, double lowest, double highest) {
    LinearAngle part = {piece.length, std::clamp(piece.first, lowest, highest),
                        std::clamp(piece.last, lowest, highest)};
    const auto cut_at = [&](double limit) {
        const double share = (limit - piece.first) / (piece.last - piece.first);
        if (share < shortest_fraction || share > 1 - shortest_fraction || share * piece.length >= part.length)
            return;
        part.length = share * piece.length;
        part.last = limit;
    };
    if (piece.first == piece.last) return part;
    cut_at(lowest);
    cut_at(highest);
    return part;
}

/// The inner minimum of Eq. (62).
double end_force_bound(const LinearAngle& piece, double normal_force, double stiffness, double remaining) {
    const double at_start = normal_force * std::tan(piece.first) + stiffness * remaining;
    const double at_end = normal_force * std::tan(piece.last) + stiffness * (remaining - piece.length);
    const double lowest = std::min(at_start, at_end);
    if (!(piece.last > piece.first) || !(stiffness > 0)) return lowest;
    // The bound is convex; its slope N tan'(angle) equals k where the cosine is this.
    const double turn = (piece.last - piece.first) / piece.length;
    const double square = normal_force * turn / stiffness;
    if (!(square < 1)) return lowest;
    const double angle = std::acos(std::sqrt(square));
    if (!(angle > piece.first && angle < piece.last)) return lowest;
    const double along = (angle - piece.first) / turn;
    return std::min(lowest, normal_force * std::tan(angle) + stiffness * (remaining - along));
}

}  // namespace rockslope::dda
