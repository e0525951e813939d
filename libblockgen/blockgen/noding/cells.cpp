#include "blockgen/noding/cells.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::blockgen {

namespace {

Int128 floor_division(Int128 numerator, Int128 denominator) {
    const Int128 quotient = numerator / denominator;
    return numerator - quotient * denominator < 0 ? quotient - 1 : quotient;
}

/// By integers. For segments a-b and c-d the crossing is a + t (b - a) with
/// t = ((c - a) x (d - c)) / ((b - a) x (d - c)).
std::optional<GridPoint> exact_crossing_cell(const FineSegment& s, const FineSegment& t,
                                             std::int64_t units_per_cell) {
    const Int128 ux = s.b.x - s.a.x, uy = s.b.y - s.a.y, vx = t.b.x - t.a.x, vy = t.b.y - t.a.y;
    const Int128 wx = t.a.x - s.a.x, wy = t.a.y - s.a.y;
    Int128 denominator = ux * vy - uy * vx;
    if (denominator == 0) return std::nullopt;
    Int128 along_s = wx * vy - wy * vx, along_t = wx * uy - wy * ux;
    if (denominator < 0) denominator = -denominator, along_s = -along_s, along_t = -along_t;
    if (along_s < 0 || along_s > denominator || along_t < 0 || along_t > denominator) return std::nullopt;
    const auto cell = [&](std::int64_t start, Int128 component) {
        const Int128 numerator = along_s * component + (start + units_per_cell / 2) * denominator;
        return static_cast<std::int64_t>(floor_division(numerator, denominator * units_per_cell));
    };
    return GridPoint{cell(s.a.x, ux), cell(s.a.y, uy)};
}

/// A number and a bound of its error.
struct Bounded {
    double value, error;
};

/// Error of a few operations relative to the largest intermediate result: eight roundings.
constexpr double relative_error = 0x1p-50;

/// p q - r s of exact factors.
Bounded difference(double p, double q, double r, double s) {
    const double first = p * q, second = r * s;
    return {first - second, relative_error * (std::abs(first) + std::abs(second))};
}

enum class Answer { no, yes, uncertain };

/// Whether a/b lies in [0, 1], for b certainly positive.
Answer is_share(const Bounded& a, const Bounded& b) {
    const double rest = b.value - a.value, error = a.error + b.error;
    if (a.value < -a.error || rest < -error) return Answer::no;
    return a.value > a.error && rest > error ? Answer::yes : Answer::uncertain;
}

/// The cell of one coordinate of the crossing, start + t component. @return whether it is certain.
bool certain_cell(std::int64_t start, double component, const Bounded& t, double units_per_cell,
                  std::int64_t& cell) {
    const double from = static_cast<double>(start);
    const double place = (from + t.value * component) / units_per_cell + 0.5, below = std::floor(place);
    const double error =
        (t.error * std::abs(component) + relative_error * (std::abs(from) + std::abs(component))) /
            units_per_cell +
        relative_error;
    cell = static_cast<std::int64_t>(below);
    return place - below > error && below + 1 - place > error;
}

/// crossing_cell() by doubles. @param cell set when the answer is yes.
Answer fast_crossing_cell(const FineSegment& s, const FineSegment& t, std::int64_t units_per_cell,
                          GridPoint& cell) {
    const auto ux = static_cast<double>(s.b.x - s.a.x), uy = static_cast<double>(s.b.y - s.a.y);
    const auto vx = static_cast<double>(t.b.x - t.a.x), vy = static_cast<double>(t.b.y - t.a.y);
    const auto wx = static_cast<double>(t.a.x - s.a.x), wy = static_cast<double>(t.a.y - s.a.y);
    Bounded denominator = difference(ux, vy, uy, vx);
    if (std::abs(denominator.value) <= 2 * denominator.error) return Answer::uncertain;
    Bounded along_s = difference(wx, vy, wy, vx), along_t = difference(wx, uy, wy, ux);
    if (denominator.value < 0) {
        denominator.value = -denominator.value;
        along_s.value = -along_s.value;
        along_t.value = -along_t.value;
    }
    const Answer within_s = is_share(along_s, denominator), within_t = is_share(along_t, denominator);
    if (within_s == Answer::no || within_t == Answer::no) return Answer::no;
    if (within_s == Answer::uncertain || within_t == Answer::uncertain) return Answer::uncertain;
    const double share = along_s.value / denominator.value;
    const Bounded at{share,
                     2 * (along_s.error + share * denominator.error) / denominator.value + relative_error};
    const auto width = static_cast<double>(units_per_cell);
    const bool is_certain =
        certain_cell(s.a.x, ux, at, width, cell.x) && certain_cell(s.a.y, uy, at, width, cell.y);
    return is_certain ? Answer::yes : Answer::uncertain;
}

/// Floating-point filter: whether the line a-b certainly misses a square. True only when its distance from
/// the centre exceeds that of every corner by more than the relative_error error.
bool certainly_misses(const GridPoint& a, const GridPoint& b, const GridPoint& middle, std::int64_t width) {
    const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const double first = static_cast<double>(middle.x - a.x) * dy;
    const double second = static_cast<double>(middle.y - a.y) * dx;
    const double reach = (std::abs(dx) + std::abs(dy)) * static_cast<double>(width) / 2;
    return std::abs(first - second) > reach * (1 + 1e-12) + 1e-14 * (std::abs(first) + std::abs(second));
}

}  // namespace

GridPoint cell_of(const GridPoint& p, std::int64_t units_per_cell) {
    const auto cell = [units_per_cell](std::int64_t x) {
        const std::int64_t shifted = x + units_per_cell / 2;
        return shifted >= 0 ? shifted / units_per_cell : -((-shifted + units_per_cell - 1) / units_per_cell);
    };
    return {cell(p.x), cell(p.y)};
}

std::optional<GridPoint> crossing_cell(const FineSegment& s, const FineSegment& t,
                                       std::int64_t units_per_cell) {
    if (std::max(s.a.x, s.b.x) < std::min(t.a.x, t.b.x) || std::max(t.a.x, t.b.x) < std::min(s.a.x, s.b.x) ||
        std::max(s.a.y, s.b.y) < std::min(t.a.y, t.b.y) || std::max(t.a.y, t.b.y) < std::min(s.a.y, s.b.y))
        return std::nullopt;
    if (s.a == t.a || s.b == t.b || s.a == t.b || s.b == t.a) return std::nullopt;
    GridPoint cell;
    switch (fast_crossing_cell(s, t, units_per_cell, cell)) {
        case Answer::no:
            return std::nullopt;
        case Answer::yes:
            return cell;
        case Answer::uncertain:
            break;
    }
    return exact_crossing_cell(s, t, units_per_cell);
}

bool intersects_square(const FineSegment& segment, const GridPoint& middle, std::int64_t width) {
    const std::int64_t half = width / 2;
    const std::int64_t left = middle.x - half, right = left + width;
    const std::int64_t bottom = middle.y - half, top = bottom + width;
    GridPoint a = segment.a, b = segment.b;
    if (b < a) std::swap(a, b);
    const std::int64_t low_y = std::min(a.y, b.y), high_y = std::max(a.y, b.y);
    if (b.x < left || a.x >= right || high_y < bottom || low_y >= top) return false;
    if (a.x == b.x || low_y == high_y) return true;
    const auto holds = [&](const GridPoint& p) {
        return p.x >= left && p.x < right && p.y >= bottom && p.y < top;
    };
    if (holds(a) || holds(b)) return true;
    if (certainly_misses(a, b, middle, width)) return false;

    const int lower_left = side_of(a, b, {left, bottom}), lower_right = side_of(a, b, {right, bottom});
    const int upper_left = side_of(a, b, {left, top}), upper_right = side_of(a, b, {right, top});
    const int lowest = std::min({lower_left, lower_right, upper_left, upper_right});
    const int highest = std::max({lower_left, lower_right, upper_left, upper_right});
    if (lowest < 0 && highest > 0 && b.x > left && a.x < right && high_y > bottom && low_y < top) return true;
    // Left and bottom sides belong to the square. The segment runs from left to right.
    if (a.x <= left && b.x >= left && lower_left <= 0 && upper_left > 0) return true;
    const bool rises = a.y < b.y;
    return low_y <= bottom && high_y >= bottom &&
           (rises ? lower_left >= 0 && lower_right < 0 : lower_left <= 0 && lower_right > 0);
}

}  // namespace rockslope::blockgen
