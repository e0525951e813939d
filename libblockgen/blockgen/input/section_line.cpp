#include "blockgen/input/section_line.hpp"

#include <cmath>
#include <numbers>

namespace rockslope::blockgen {

double SectionLine::length() const {
    return std::hypot(to.x - from.x, to.y - from.y);
}

double SectionLine::azimuth() const {
    const double angle = std::atan2(to.x - from.x, to.y - from.y);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

Point SectionLine::at(double x) const {
    const double part = x / length();
    return {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
}

double SectionLine::along(const Point& p) const {
    return ((p.x - from.x) * (to.x - from.x) + (p.y - from.y) * (to.y - from.y)) / length();
}

double SectionLine::across(const Point& p) const {
    return ((to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x)) / length();
}

}  // namespace rockslope::blockgen
