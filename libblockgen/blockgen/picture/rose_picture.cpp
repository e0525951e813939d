#include "blockgen/picture/rose_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "common/drawing/axes.hpp"

namespace rockslope::blockgen {

namespace {

using std::numbers::pi;

constexpr double rose_width = 400, rose_margin = 34, rose_legend_row = 16, rose_legend_top = 30;

constexpr int most_circles = 4;

/// The page round the rose, and the scale of its petals.
class RosePage {
  public:
    /// @param largest share of the length in a class.
    RosePage(double width, double largest)
        : centre_{width / 2, width / 2}, radius_(width / 2 - rose_margin), largest_(largest) {}

    /// The radius up to which a share of the length is drawn: areas are proportional to shares.
    double radius_of(double share) const { return radius_ * std::sqrt(share / largest_); }
    double radius() const { return radius_; }
    const Point& centre() const { return centre_; }
    Point at(double radius, double angle) const {
        return {centre_.x + radius * std::cos(angle), centre_.y - radius * std::sin(angle)};
    }
    /// The part of a class of directions between two radii.
    Ring petal(double inner, double outer, double from, double to) const {
        constexpr int steps = 8;
        Ring ring;
        for (int k = 0; k <= steps; ++k) ring.push_back(at(outer, from + (to - from) * k / steps));
        for (int k = steps; k >= 0; --k) ring.push_back(at(inner, from + (to - from) * k / steps));
        return ring;
    }

  private:
    Point centre_;
    double radius_, largest_;
};

void draw_grid(Canvas& canvas, const RosePage& page, double largest) {
    constexpr int rays = 12;
    for (int k = 0; k < rays; ++k) {
        const double angle = 2 * pi * k / rays;
        canvas.polyline(std::vector<Point>{page.centre(), page.at(page.radius(), angle)}, {pale_grey, 0.5});
        const double degrees = std::remainder(180.0 * 2 * k / rays, 180.0);
        char text[32];
        std::snprintf(text, sizeof text, "%g\u00b0", degrees == -90 ? 90 : degrees);
        canvas.text(page.at(page.radius() + 16, angle), text, {9, black, Anchor::middle, Anchor::middle});
    }
    for (const double share : round_ticks({0, largest}, most_circles)) {
        if (!(share > 0)) continue;
        canvas.circle(page.centre(), page.radius_of(share), std::nullopt, Stroke{pale_grey, 0.5});
    }
}

void draw_shares(Canvas& canvas, const RosePage& page, double largest) {
    for (const double share : round_ticks({0, largest}, most_circles)) {
        if (!(share > 0)) continue;
        char text[32];
        std::snprintf(text, sizeof text, "%.3g %%", 100 * share);
        TextStyle letters{8, grey, Anchor::middle, Anchor::middle};
        letters.halo = white;
        canvas.text(page.at(page.radius_of(share), pi * 7 / 12), text, letters);
    }
}

}  // namespace

Canvas draw_rose(std::span<const RoseSet> sets, const PageStyle& style) {
    const double width = style.width_in_units(rose_width);
    Canvas canvas(width, width + rose_legend_top + rose_legend_row * static_cast<double>(sets.size() + 1),
                  style);
    std::vector<double> in_class(sets.empty() ? 0 : sets[0].length_by_direction.size(), 0);
    double total = 0;
    for (const RoseSet& set : sets)
        for (std::size_t k = 0; k < in_class.size(); ++k) {
            in_class[k] += set.length_by_direction[k];
            total += set.length_by_direction[k];
        }
    if (!(total > 0)) return canvas;
    const double largest = *std::max_element(in_class.begin(), in_class.end()) / total;
    const RosePage page(width, largest);
    draw_grid(canvas, page, largest);
    const double class_width = pi / static_cast<double>(in_class.size());
    std::vector<double> below(in_class.size(), 0);
    std::vector<LegendEntry> entries;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        for (std::size_t k = 0; k < in_class.size(); ++k) {
            const double share = sets[s].length_by_direction[k] / total;
            if (!(share > 0)) continue;
            const double inner = page.radius_of(below[k]), outer = page.radius_of(below[k] += share);
            const double from = -pi / 2 + class_width * static_cast<double>(k);
            for (const double turn : {0.0, pi})
                canvas.polygon(
                    std::vector<Ring>{page.petal(inner, outer, from + turn, from + class_width + turn)},
                    line_colour(s), Stroke{white, 0.5});
        }
        entries.push_back({sets[s].name, line_colour(s), std::nullopt, false});
    }
    draw_shares(canvas, page, largest);
    draw_legend(canvas, {rose_margin, width}, "Length by direction", entries, width - 2 * rose_margin);
    return canvas;
}

}  // namespace rockslope::blockgen
