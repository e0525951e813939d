#include "frame_labels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "common/geometry/polygon.hpp"

namespace rockslope {

namespace {

constexpr double number_size = 6.5, name_size = 8;

/// Whether a place of the page lies within the axes.
bool is_shown(const Axes& axes, const Point& place) {
    return place.x > axes.upper_left().x && place.x < axes.lower_right().x && place.y > axes.upper_left().y &&
           place.y < axes.lower_right().y;
}

double length_of(const std::vector<Point>& line) {
    return line.size() < 2 ? 0 : std::hypot(line[1].x - line[0].x, line[1].y - line[0].y);
}

}  // namespace

void label_blocks(Canvas& canvas, const Axes& axes, const dda::GridFrame& blocks) {
    const TextStyle style{number_size, black, Anchor::middle, Anchor::middle, false, 0, white};
    for (std::size_t b = 0; b < blocks.cells.count(); ++b) {
        const Ring ring = axes.to_page(cell_points(blocks, b));
        const std::string number = std::to_string(std::lround(blocks.columns[0][b]));
        const auto [west, east] =
            std::minmax_element(ring.begin(), ring.end(), [](auto& p, auto& q) { return p.x < q.x; });
        const Point centre = centroid(ring);
        if (east->x - west->x > 1.2 * canvas.text_width(number, style) && is_shown(axes, centre))
            canvas.text(centre, number, style);
    }
}

void label_joints(Canvas& canvas, const Axes& axes, const dda::GridFrame& contacts,
                  const std::vector<std::string>& names) {
    std::map<std::string, std::vector<Point>> longest;
    for (std::size_t c = 0; c < contacts.cells.count(); ++c) {
        const long joint = std::lround(contacts.columns[0][c]);
        if (joint < 0 || static_cast<std::size_t>(joint) >= names.size()) continue;
        std::vector<Point> line = cell_points(contacts, c);
        for (Point& point : line) point = axes.to_page(point);
        auto& best = longest[names[static_cast<std::size_t>(joint)]];
        const bool inside = line.size() == 2 && is_shown(axes, line[0]) && is_shown(axes, line[1]);
        if (inside && length_of(line) > length_of(best)) best = line;
    }
    for (const auto& [name, line] : longest) {
        if (line.empty()) continue;
        double angle = -std::atan2(line[1].y - line[0].y, line[1].x - line[0].x);
        if (std::abs(angle) > std::numbers::pi / 2) angle -= std::copysign(std::numbers::pi, angle);
        canvas.text({(line[0].x + line[1].x) / 2, (line[0].y + line[1].y) / 2}, name,
                    {name_size, black, Anchor::middle, Anchor::middle, true, angle, white});
    }
}

}  // namespace rockslope
