#include "common/drawing/fitted_text.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope {

namespace {

/// Height of a label over the size of its letters, and what of it lies above the baseline.
constexpr double height_ratio = 1.1, ascent_ratio = 0.85, cap_height = 0.73;

double fraction_of(Anchor anchor) {
    return anchor == Anchor::start ? 0.0 : anchor == Anchor::middle ? 0.5 : 1.0;
}

}  // namespace

std::string shortened(const Canvas& canvas, const std::string& line, const TextStyle& style, double room) {
    if (canvas.text_width(line, style) <= room) return line;
    std::string kept = line;
    while (!kept.empty()) {
        // The last letter, which may have several bytes.
        while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xc0) == 0x80) kept.pop_back();
        if (!kept.empty()) kept.pop_back();
        if (canvas.text_width(kept + "…", style) <= room) break;
    }
    while (!kept.empty() && kept.back() == ' ') kept.pop_back();
    return kept + "…";
}

Labels::Box Labels::box_of(const Canvas& canvas, const Point& place, const std::string& line,
                           const TextStyle& style) {
    const double width = canvas.text_width(line, style), height = height_ratio * style.size;
    const double left = -fraction_of(style.anchor) * width;
    const double top = fraction_of(style.vertical) * cap_height * style.size - ascent_ratio * style.size;
    Box box{1e300, -1e300, 1e300, -1e300};
    for (const double x : {left, left + width})
        for (const double y : {top, top + height}) {
            const double c = std::cos(style.angle), s = std::sin(style.angle);
            const Point corner{place.x + c * x + s * y, place.y - s * x + c * y};
            box.left = std::min(box.left, corner.x);
            box.right = std::max(box.right, corner.x);
            box.top = std::min(box.top, corner.y);
            box.bottom = std::max(box.bottom, corner.y);
        }
    return box;
}

bool Labels::is_free(const Box& box) const {
    const bool inside = box.left >= upper_left_.x && box.right <= lower_right_.x &&
                        box.top >= upper_left_.y && box.bottom <= lower_right_.y;
    return inside && std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
               return box.left < other.right && other.left < box.right && box.top < other.bottom &&
                      other.top < box.bottom;
           });
}

bool Labels::try_at(Canvas& canvas, const Point& place, const std::string& line, const TextStyle& style) {
    const Box box = box_of(canvas, place, line, style);
    if (!is_free(box)) return false;
    canvas.text(place, line, style);
    taken_.push_back(box);
    return true;
}

void Labels::put(Canvas& canvas, const std::vector<std::pair<Point, Anchor>>& places, const std::string& line,
                 TextStyle style) {
    for (const auto& [place, anchor] : places) {
        style.anchor = anchor;
        if (try_at(canvas, place, line, style)) return;
    }
    style.anchor = places.front().second;
    const std::string text = shortened(canvas, line, style, lower_right_.x - upper_left_.x);
    const Point wanted = places.front().first;
    const Box box = box_of(canvas, wanted, text, style);
    const auto shift = [](double low, double high, double from, double to) {
        return std::max(from - low, std::min(0.0, to - high));
    };
    const Point place{wanted.x + shift(box.left, box.right, upper_left_.x, lower_right_.x),
                      wanted.y + shift(box.top, box.bottom, upper_left_.y, lower_right_.y)};
    canvas.text(place, text, style);
    taken_.push_back(box_of(canvas, place, text, style));
}

}  // namespace rockslope
