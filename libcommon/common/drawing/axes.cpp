#include "common/drawing/axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/drawing/fitted_text.hpp"

namespace rockslope {

namespace {

constexpr double box_width = 16, box_height = 9;  // of the mark of a legend

/// The smallest of 1, 2, 5 times a power of ten that is at least `length`.
double round_up(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= length * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

double tick_step(const Range& range, int most) {
    return round_up((range.high - range.low) / most);
}

/// The most ticks that there is room for, or more, so that there are two: one tick says nothing of the scale.
int enough_ticks(const Range& range, int most) {
    constexpr int many = 8;
    int enough = std::max(2, most);
    while (enough < many && round_ticks(range, enough).size() < 2) ++enough;
    return enough;
}

}  // namespace

std::vector<double> round_ticks(const Range& range, int most) {
    std::vector<double> ticks;
    if (!(range.high > range.low)) return ticks;
    const double step = tick_step(range, most);
    const double slack = 1e-9 * (range.high - range.low);
    for (double k = std::ceil((range.low - slack) / step); k * step <= range.high + slack; k += 1)
        ticks.push_back(k * step + 0.0);
    return ticks;
}

std::string tick_text(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 12);
    char text[64];
    if (std::abs(value) >= 1e9 || step < 1e-5)
        std::snprintf(text, sizeof text, "%.4g", value);
    else
        std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text[0] == '-' ? "\u2212" + std::string(text + 1) : text;
}

TickLabels tick_labels(const Range& range, int most) {
    constexpr std::size_t longest_tick = 7;
    TickLabels labels{round_ticks(range, most), {}, 0};
    if (labels.values.empty()) return labels;
    const double step = tick_step(range, most);
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    const int digits = 1 + std::max(0, static_cast<int>(std::floor(std::log10(largest))));
    if (digits + decimals + (decimals > 0 ? 1 : 0) > static_cast<int>(longest_tick)) {
        const double power = std::pow(10.0, std::ceil(std::log10(range.high - range.low) - 1e-9));
        labels.offset = std::floor(labels.values.front() / power) * power + 0.0;
        // A range that contains zero has no common offset, however long its labels are.
        if (range.low <= 0 && range.high >= 0) labels.offset = 0;
    }
    for (const double value : labels.values) labels.texts.push_back(tick_text(value - labels.offset, step));
    return labels;
}

std::string TickLabels::title(const std::string& quantity) const {
    if (offset == 0) return quantity;
    const std::size_t unit = std::min(quantity.find(" ("), quantity.size());
    char text[64];
    std::snprintf(text, sizeof text, "%.12g", std::abs(offset));
    return quantity.substr(0, unit) + (offset < 0 ? " + " : " \u2212 ") + text + quantity.substr(unit);
}

Axes::Axes(Point upper_left, Point lower_right, Range x, Range y)
    : upper_left_(upper_left), lower_right_(lower_right), x_(x), y_(y) {}

Axes Axes::of_equal_scale(Point upper_left, Point lower_right, Range x, Range y) {
    const double width = lower_right.x - upper_left.x, height = lower_right.y - upper_left.y;
    const double scale = std::min(width / (x.high - x.low), height / (y.high - y.low));
    const double dx = (width - scale * (x.high - x.low)) / 2, dy = (height - scale * (y.high - y.low)) / 2;
    return {{upper_left.x + dx, upper_left.y + dy}, {lower_right.x - dx, lower_right.y - dy}, x, y};
}

Point Axes::to_page(const Point& p) const {
    return {upper_left_.x + (p.x - x_.low) / (x_.high - x_.low) * (lower_right_.x - upper_left_.x),
            lower_right_.y - (p.y - y_.low) / (y_.high - y_.low) * (lower_right_.y - upper_left_.y)};
}

Ring Axes::to_page(const Ring& ring) const {
    Ring page;
    page.reserve(ring.size());
    for (const Point& p : ring) page.push_back(to_page(p));
    return page;
}

void Axes::draw(Canvas& canvas, const std::string& x_title, const std::string& y_title, bool grid) const {
    const Stroke line{grey, 0.7}, thin{pale_grey, 0.5};
    const TextStyle numbers{8, black, Anchor::middle, Anchor::end};
    const int x_most = enough_ticks(x_, static_cast<int>((lower_right_.x - upper_left_.x) / 55));
    const int y_most = enough_ticks(y_, static_cast<int>((lower_right_.y - upper_left_.y) / 40));
    double widest = 0;
    const TickLabels x_labels = tick_labels(x_, x_most), y_labels = tick_labels(y_, y_most);
    for (std::size_t k = 0; k < x_labels.values.size(); ++k) {
        const double page_x = to_page({x_labels.values[k], y_.low}).x;
        if (grid)
            canvas.polyline(std::vector<Point>{{page_x, upper_left_.y}, {page_x, lower_right_.y}}, thin);
        canvas.polyline(std::vector<Point>{{page_x, lower_right_.y}, {page_x, lower_right_.y + 3.5}}, line);
        canvas.text({page_x, lower_right_.y + 6}, x_labels.texts[k], numbers);
    }
    for (std::size_t k = 0; k < y_labels.values.size(); ++k) {
        const double page_y = to_page({x_.low, y_labels.values[k]}).y;
        const TextStyle style{8, black, Anchor::end, Anchor::middle};
        const std::string& text = y_labels.texts[k];
        if (grid)
            canvas.polyline(std::vector<Point>{{upper_left_.x, page_y}, {lower_right_.x, page_y}}, thin);
        canvas.polyline(std::vector<Point>{{upper_left_.x - 3.5, page_y}, {upper_left_.x, page_y}}, line);
        canvas.text({upper_left_.x - 6, page_y}, text, style);
        widest = std::max(widest, canvas.text_width(text, style));
    }
    const Ring frame = {
        upper_left_, {lower_right_.x, upper_left_.y}, lower_right_, {upper_left_.x, lower_right_.y}};
    canvas.polygon(std::vector<Ring>{frame}, std::nullopt, line);
    canvas.text({(upper_left_.x + lower_right_.x) / 2, lower_right_.y + 19}, x_labels.title(x_title),
                {9, black, Anchor::middle, Anchor::end});
    canvas.text({upper_left_.x - widest - 13, (upper_left_.y + lower_right_.y) / 2}, y_labels.title(y_title),
                {9, black, Anchor::middle, Anchor::start, false, M_PI / 2});
}

void draw_scale_bar(Canvas& canvas, const Point& place, double points_per_metre, double longest_points) {
    double length = round_up(longest_points / points_per_metre);
    while (length * points_per_metre > longest_points * (1 + 1e-9)) {
        const double lead = length / std::pow(10.0, std::floor(std::log10(length) + 1e-9));
        length /= lead > 4 && lead < 6 ? 2.5 : 2;
    }
    const double width = length * points_per_metre;
    for (int k = 0; k < 4; ++k) {
        const double x0 = place.x + k * width / 4, x1 = x0 + width / 4;
        const Ring box = {{x0, place.y}, {x1, place.y}, {x1, place.y + 4}, {x0, place.y + 4}};
        canvas.polygon(std::vector<Ring>{box}, k % 2 == 0 ? black : white, Stroke{black, 0.5});
    }
    canvas.text({place.x, place.y + 8}, "0", {8, black, Anchor::middle, Anchor::end});
    canvas.text({place.x + width, place.y + 8}, tick_text(length, length) + " m",
                {8, black, Anchor::middle, Anchor::end});
}

void draw_legend_entry(Canvas& canvas, const Point& upper_left, const LegendEntry& entry, double text_room) {
    const double middle = upper_left.y + box_height / 2;
    const Ring box = {upper_left,
                      {upper_left.x + box_width, upper_left.y},
                      {upper_left.x + box_width, upper_left.y + box_height},
                      {upper_left.x, upper_left.y + box_height}};
    if (entry.is_circle)
        canvas.circle({upper_left.x + box_width / 2, middle}, 1.8, entry.fill, entry.stroke);
    else if (entry.is_line && entry.stroke)
        canvas.polyline(std::vector<Point>{{upper_left.x, middle}, {upper_left.x + box_width, middle}},
                        *entry.stroke);
    else
        canvas.polygon(std::vector<Ring>{box}, entry.fill, entry.stroke);
    if (entry.is_hatched) canvas.hatch(std::vector<Ring>{box}, {grey, 0.6}, 3, M_PI / 4);
    const TextStyle style{9, black, Anchor::start, Anchor::middle};
    canvas.text({upper_left.x + box_width + 6, middle}, shortened(canvas, entry.text, style, text_room),
                style);
}

double draw_legend(Canvas& canvas, const Point& upper_left, const std::string& title,
                   const std::vector<LegendEntry>& entries, double room) {
    constexpr double row = 14;
    const TextStyle heading{9, black, Anchor::start, Anchor::end, true};
    double y = upper_left.y;
    canvas.text({upper_left.x, y}, shortened(canvas, title, heading, room), heading);
    y += row + 2;
    for (const LegendEntry& entry : entries) {
        draw_legend_entry(canvas, {upper_left.x, y}, entry, room - box_width - 6);
        y += row;
    }
    return y + 8;
}

}  // namespace rockslope
