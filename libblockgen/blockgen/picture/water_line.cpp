#include "blockgen/picture/water_line.hpp"

#include <algorithm>

namespace rockslope::blockgen {

namespace {

constexpr Colour blue{0.04, 0.36, 0.82};
const Stroke water_stroke{blue, 1.6, {7, 3.5}};

/// The height at x of a line on the page whose x grows.
double height_at(const std::vector<Point>& line, double x) {
    for (std::size_t k = 1; k < line.size(); ++k) {
        const Point &p = line[k - 1], &q = line[k];
        if (x <= q.x) return p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
    }
    return line.back().y;
}

/// A triangle with its tip on the water, and two strokes below.
void draw_mark(Canvas& canvas, const Point& tip, double size) {
    const std::vector<Ring> triangle = {
        {tip, {tip.x - size / 2, tip.y - 0.87 * size}, {tip.x + size / 2, tip.y - 0.87 * size}}};
    canvas.polygon(triangle, white, Stroke{blue, 1.1});
    for (const double below : {0.3, 0.6}) {
        const double half = (0.8 - below) / 1.4 * size, y = tip.y + below * size;
        canvas.polyline(std::vector<Point>{{tip.x - half, y}, {tip.x + half, y}}, {blue, 1.1});
    }
}

}  // namespace

void draw_water_line(Canvas& canvas, const Axes& axes, const std::vector<Point>& line) {
    const double left = axes.upper_left().x, right = axes.lower_right().x;
    std::vector<Point> on_page;
    for (const Point& p : line) on_page.push_back(axes.to_page(p));
    if (on_page.front().x > left) on_page.insert(on_page.begin(), {left, on_page.front().y});
    if (on_page.back().x < right) on_page.push_back({right, on_page.back().y});
    canvas.clip(axes.upper_left(), axes.lower_right());
    canvas.polyline(on_page, {white, 3});
    canvas.polyline(on_page, water_stroke);
    const bool is_left = height_at(on_page, left) <= height_at(on_page, right);  // y points down on a page
    const double x = left + (is_left ? 0.12 : 0.88) * (right - left);
    draw_mark(canvas, {x, height_at(on_page, x)}, 10);
    canvas.unclip();
}

double draw_water_legend(Canvas& canvas, const Point& upper_left) {
    const double middle = upper_left.y + 6;
    canvas.polyline(std::vector<Point>{{upper_left.x, middle}, {upper_left.x + 16, middle}}, water_stroke);
    draw_mark(canvas, {upper_left.x + 8, middle}, 7);
    canvas.text({upper_left.x + 22, middle}, "water table", {9, black, Anchor::start, Anchor::middle});
    return upper_left.y + 15;
}

}  // namespace rockslope::blockgen
