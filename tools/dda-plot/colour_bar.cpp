#include "colour_bar.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numbers>

#include "common/drawing/axes.hpp"

namespace rockslope {

namespace {

constexpr double thickness = 13, tip = 11, tick = 3;
const Stroke outline{black, 0.5};

bool has_tip(const ColourBar& bar) {
    return bar.range.farthest > bar.range.largest * (1 + 1e-9);
}

/// The value at a position along a bar.
double value_at(const ColourBar& bar, double along) {
    return bar.range.largest * (bar.range.is_signed ? 2 * along - 1 : along);
}

/// Maps a position in the bar to the page. `along` is 0 at the pale end and 1 at the dark end; `past` is the
/// distance beyond the dark end, pt; `across` is the distance from the edge opposite the ticks, pt.
using Place = std::function<Point(double along, double past, double across)>;

void draw_shades(Canvas& canvas, const ColourBar& bar, const Place& place) {
    constexpr int shades = 64;
    for (int i = 0; i < shades; ++i) {
        // Each shade overlaps the next, so that no white line shows between two shades.
        const double from = i / double{shades}, to = std::min(1.0, (i + 1.5) / shades);
        const Ring strip = {place(from, 0, 0), place(from, 0, thickness), place(to, 0, thickness),
                            place(to, 0, 0)};
        canvas.polygon(std::span(&strip, 1), bar.range.colour_of(value_at(bar, (i + 0.5) / shades)),
                       std::nullopt);
    }
    Ring frame = {place(0, 0, 0), place(0, 0, thickness), place(1, 0, thickness), place(1, 0, 0)};
    if (has_tip(bar)) {
        const Ring more = {place(1, 0, 0), place(1, 0, thickness), place(1, tip, thickness / 2)};
        canvas.polygon(std::span(&more, 1), bar.range.colour_of(bar.range.largest), std::nullopt);
        frame.insert(frame.begin() + 3, place(1, tip, thickness / 2));
    }
    if (has_tip(bar) && bar.range.is_signed) {
        const Ring more = {place(0, 0, 0), place(0, 0, thickness), place(0, -tip, thickness / 2)};
        canvas.polygon(std::span(&more, 1), bar.range.colour_of(-bar.range.largest), std::nullopt);
        frame.insert(frame.begin() + 1, place(0, -tip, thickness / 2));
    }
    canvas.polygon(std::span(&frame, 1), std::nullopt, outline);
}

void draw_ticks(Canvas& canvas, const ColourBar& bar, const Place& place, const TextStyle& style) {
    const double largest = bar.range.largest * readable_unit(bar.unit, bar.range.largest).factor;
    const double smallest = bar.range.is_signed ? -largest : 0;
    const std::vector<double> ticks = round_ticks({smallest, largest}, 6);
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : largest;
    for (const double value : ticks) {
        const double along = (value - smallest) / (largest - smallest);
        canvas.polyline(std::vector<Point>{place(along, 0, thickness), place(along, 0, thickness + tick)},
                        outline);
        canvas.text(place(along, 0, thickness + tick + 2), tick_text(value, step), style);
    }
}

std::string title_of(const ColourBar& bar) {
    const std::string unit = readable_unit(bar.unit, bar.range.largest).name;
    return unit.empty() ? bar.title : bar.title + " (" + unit + ")";
}

/// "max 3.21 m" when a value exceeds the end of the bar; otherwise empty.
std::string farthest_text(const ColourBar& bar) {
    if (!has_tip(bar)) return {};
    const ReadableUnit unit = readable_unit(bar.unit, bar.range.farthest);
    char number[32];
    std::snprintf(number, sizeof number, "max %.3g ", bar.range.farthest * unit.factor);
    return number + unit.name;
}

/// Room for the tips at the ends of a bar, pt: one, or two.
double room_of_tips(const ColourBar& bar) {
    return has_tip(bar) ? (bar.range.is_signed ? 2 * tip : tip) : 0;
}

}  // namespace

Colour ColourRange::colour_of(double value) const {
    if (!is_signed) return scale_colour(pale + (1 - pale) * value / largest);
    return diverging_colour(value / largest);
}

void draw_vertical_bar(Canvas& canvas, const ColourBar& bar, const Point& foot, double length) {
    const double room = room_of_tips(bar), low = bar.range.is_signed && has_tip(bar) ? tip : 0;
    const Place place = [&](double along, double past, double across) {
        return Point{foot.x + across, foot.y - low - along * (length - room) - past};
    };
    draw_shades(canvas, bar, place);
    draw_ticks(canvas, bar, place, {8, black, Anchor::start, Anchor::middle});
    canvas.text({foot.x + thickness + tick + 2, foot.y - length}, farthest_text(bar),
                {8, black, Anchor::start, Anchor::middle});
    canvas.text({foot.x + thickness + 42, foot.y - length / 2}, title_of(bar),
                {9, black, Anchor::middle, Anchor::middle, false, std::numbers::pi / 2});
}

void draw_horizontal_bar(Canvas& canvas, const ColourBar& bar, const Point& corner, double length) {
    const double room = room_of_tips(bar), low = bar.range.is_signed && has_tip(bar) ? tip : 0;
    const Place place = [&](double along, double past, double across) {
        return Point{corner.x + low + along * (length - room) + past, corner.y + across};
    };
    draw_shades(canvas, bar, place);
    draw_ticks(canvas, bar, place, {8, black, Anchor::middle, Anchor::end});
    canvas.text({corner.x + length + 6, corner.y + thickness / 2}, farthest_text(bar),
                {8, black, Anchor::start, Anchor::middle});
    canvas.text({corner.x + length / 2, corner.y + thickness + 17}, title_of(bar),
                {9, black, Anchor::middle, Anchor::end});
}

}  // namespace rockslope
