#include "frame_labels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "common/geometry/polygon.hpp"

namespace rockslope {

namespace {

constexpr double number_size = 6.5, name_size = 8;

double length_of(const std::vector<Point>& line) {
    return std::hypot(line[1].x - line[0].x, line[1].y - line[0].y);
}

/// The contacts of each set of joints as lines on the page, the longest first.
std::map<std::string, std::vector<std::vector<Point>>> lines_of_sets(const Axes& axes,
                                                                     const dda::GridFrame& contacts,
                                                                     const std::vector<std::string>& names) {
    std::map<std::string, std::vector<std::vector<Point>>> lines;
    for (std::size_t c = 0; c < contacts.cells.count(); ++c) {
        const long joint = std::lround(contacts.columns[0][c]);
        if (joint < 0 || static_cast<std::size_t>(joint) >= names.size()) continue;
        std::vector<Point> line = cell_points(contacts, c);
        for (Point& point : line) point = axes.to_page(point);
        if (line.size() == 2) lines[names[static_cast<std::size_t>(joint)]].push_back(line);
    }
    for (auto& [name, of_set] : lines)
        std::stable_sort(of_set.begin(), of_set.end(),
                         [](const auto& p, const auto& q) { return length_of(p) > length_of(q); });
    return lines;
}

/// The angle of a line that text along it has to be read from the left, rad.
double reading_angle(const std::vector<Point>& line) {
    const double angle = -std::atan2(line[1].y - line[0].y, line[1].x - line[0].x);
    return std::abs(angle) > std::numbers::pi / 2 ? angle - std::copysign(std::numbers::pi, angle) : angle;
}

Point middle_of(const std::vector<Point>& line) {
    return {(line[0].x + line[1].x) / 2, (line[0].y + line[1].y) / 2};
}

/// Places for the number of a block: its centroid, half-way from there to its corners, half-way between
/// corners. Any of them may be outside.
std::vector<Point> places_in(const Ring& ring) {
    const Point centre = centroid(ring);
    std::vector<Point> places = {centre};
    for (const Point& corner : ring) places.push_back(middle_of({centre, corner}));
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = i + 2; j < ring.size(); ++j) places.push_back(middle_of({ring[i], ring[j]}));
    return places;
}

}  // namespace

void label_blocks(Canvas& canvas, const Axes& axes, const dda::GridFrame& blocks, Labels& labels) {
    const TextStyle style{number_size, black, Anchor::middle, Anchor::middle, false, 0, white};
    for (std::size_t b = 0; b < blocks.cells.count(); ++b) {
        const Ring ring = axes.to_page(cell_points(blocks, b));
        const std::string number = std::to_string(std::lround(blocks.columns[0][b]));
        const auto [west, east] =
            std::minmax_element(ring.begin(), ring.end(), [](auto& p, auto& q) { return p.x < q.x; });
        if (east->x - west->x <= 1.2 * canvas.text_width(number, style)) continue;
        const std::vector<Point> places = places_in(ring);
        std::any_of(places.begin(), places.end(), [&](const Point& place) {
            return side_of_ring(ring, place) > 0 && labels.try_at(canvas, place, number, style);
        });
    }
}

void label_joints(Canvas& canvas, const Axes& axes, const dda::GridFrame& contacts,
                  const std::vector<std::string>& names, Labels& labels) {
    TextStyle style{name_size, black, Anchor::middle, Anchor::middle, true, 0, white};
    for (const auto& [name, lines] : lines_of_sets(axes, contacts, names)) {
        const bool found = std::any_of(lines.begin(), lines.end(), [&, &text = name](const auto& line) {
            style.angle = reading_angle(line);
            return labels.try_at(canvas, middle_of(line), text, style);
        });
        if (found) continue;
        style.angle = 0;
        labels.put(canvas, {{middle_of(lines.front()), Anchor::middle}}, name, style);
    }
}

}  // namespace rockslope
