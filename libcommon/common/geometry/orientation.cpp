#include "common/geometry/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rockslope {

namespace {

/// An exact sum of doubles kept as non-overlapping parts of increasing magnitude.
struct ExactSum {
    std::array<double, 16> part{};
    int count = 0;

    void add(double value) {
        for (int i = 0; i < count; ++i) {
            const double p = part[i];
            const double sum = value + p;
            const double virtual_p = sum - value;
            part[i] = (value - (sum - virtual_p)) + (p - virtual_p);
            value = sum;
        }
        part[count++] = value;
    }

    void add_product(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }

    int sign() const {
        for (int i = count; i-- > 0;) {
            const double p = part[i];
            if (p != 0) return p > 0 ? 1 : -1;
        }
        return 0;
    }
};

bool in_box(const Point& a, const Point& b, const Point& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

/// Relation of the collinear segments a-b and c-d, from their order along the dominant direction of a-b.
SegmentRelation collinear_relation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const bool by_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const auto along = [by_x](const Point& p) { return by_x ? p.x : p.y; };
    const double low = std::max(std::min(along(a), along(b)), std::min(along(c), along(d)));
    const double high = std::min(std::max(along(a), along(b)), std::max(along(c), along(d)));
    if (low > high) return SegmentRelation::apart;
    return low < high ? SegmentRelation::overlapping : SegmentRelation::endpoint;
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    constexpr double bound = 3.3306690738754716e-16;  // (3 + 16 u) u with u = 2^-53, Shewchuk's filter A
    if (std::abs(determinant) > bound * (std::abs(left) + std::abs(right))) return determinant > 0 ? 1 : -1;
    ExactSum sum;
    sum.add_product(a.x, b.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-c.x, b.y);
    sum.add_product(-a.y, b.x);
    sum.add_product(a.y, c.x);
    sum.add_product(c.y, b.x);
    return sum.sign();
}

SegmentRelation segment_relation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int c_side = orientation(a, b, c);
    const int d_side = orientation(a, b, d);
    if (c_side == 0 && d_side == 0) return collinear_relation(a, b, c, d);
    const int a_side = orientation(c, d, a);
    const int b_side = orientation(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) return SegmentRelation::crossing;
    if (a == c || a == d || b == c || b == d) return SegmentRelation::endpoint;
    const bool touches = (c_side == 0 && in_box(a, b, c)) || (d_side == 0 && in_box(a, b, d)) ||
                         (a_side == 0 && in_box(c, d, a)) || (b_side == 0 && in_box(c, d, b));
    return touches ? SegmentRelation::touching : SegmentRelation::apart;
}

}  // namespace rockslope
