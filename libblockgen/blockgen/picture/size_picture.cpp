#include "blockgen/picture/block_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "blockgen/mesh/measures.hpp"
#include "common/drawing/axes.hpp"
#include "common/drawing/fitted_text.hpp"

namespace rockslope::blockgen {

namespace {

constexpr double chart_width = 560, chart_left = 62, chart_right = 24, chart_top = 24, below_chart = 62;
/// Height of the axes over their width, on a narrow page.
constexpr double highest = 0.9, usual_height = 294;
/// Narrowest page with the legend inside the axes, and the size of the legend.
constexpr double least_width_inside = 480, size_legend_width = 150, size_legend_height = 50;

std::vector<double> sorted_areas(const BlockMesh& mesh) {
    std::vector<double> areas;
    for (const BlockIndex b : mesh.blocks()) areas.push_back(block_area(mesh, b));
    std::sort(areas.begin(), areas.end());
    return areas;
}

/// Range of powers of ten that contains the areas, at least one decade.
Range decades(const std::vector<double>& areas) {
    const double low = std::floor(std::log10(areas.front())), high = std::ceil(std::log10(areas.back()));
    return high > low ? Range{low, high} : Range{low - 1, high + 1};
}

/// Cumulative distribution of the sorted areas as a step curve; steps below 0.2 points are left out.
std::vector<Point> step_curve(const std::vector<double>& areas, const Axes& axes, bool by_area) {
    double total = 0, sum = 0;
    for (const double area : areas) total += by_area ? area : 1;
    std::vector<Point> line = {axes.to_page({std::log10(areas.front()), 0})};
    for (const double area : areas) {
        sum += by_area ? area : 1;
        const Point p = axes.to_page({std::log10(area), 100 * sum / total});
        if (std::abs(p.x - line.back().x) + std::abs(p.y - line.back().y) < 0.2 && area < areas.back())
            continue;
        line.push_back({p.x, line.back().y});
        line.push_back(p);
    }
    return line;
}

std::string size_text(double area) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g m\u00b2", area);
    return text;
}

void draw_decades(Canvas& canvas, const Range& range, const Axes& axes) {
    constexpr double room = 58;  // of a number
    const Point lower_right = axes.lower_right();
    const double decade = (lower_right.x - axes.upper_left().x) / (range.high - range.low);
    const int step = std::max(1, static_cast<int>(std::ceil(room / decade)));
    for (int k = static_cast<int>(range.low); k <= static_cast<int>(range.high); ++k) {
        const double x = axes.to_page({static_cast<double>(k), 0}).x;
        canvas.polyline(std::vector<Point>{{x, lower_right.y}, {x, lower_right.y + 4}}, {grey, 0.6});
        if ((k - static_cast<int>(range.low)) % step != 0) continue;
        char text[32];
        std::snprintf(text, sizeof text, "%g", std::pow(10.0, k));
        canvas.text({x, lower_right.y + 14}, text, {9, black, Anchor::middle, Anchor::middle});
    }
}

void draw_fraction_axis(Canvas& canvas, const Axes& axes, const Range& range) {
    const Point upper_left = axes.upper_left(), lower_right = axes.lower_right();
    for (int percent = 0; percent <= 100; percent += 20) {
        const double y = axes.to_page({range.low, static_cast<double>(percent)}).y;
        canvas.polyline(std::vector<Point>{{upper_left.x, y}, {lower_right.x, y}}, {pale_grey, 0.5});
        canvas.text({upper_left.x - 6, y}, std::to_string(percent) + " %",
                    {9, black, Anchor::end, Anchor::middle});
    }
}

}  // namespace

Canvas draw_sizes(const BlockMesh& mesh, const PageStyle& style) {
    const double width = style.width_in_units(chart_width), across = width - chart_left - chart_right;
    const double height = std::min(usual_height, highest * across);
    const Point upper_left{chart_left, chart_top}, lower_right{chart_left + across, chart_top + height};
    const bool is_wide = width >= least_width_inside;
    const double below = lower_right.y + below_chart;
    Canvas canvas(width, is_wide ? below : below + size_legend_height, style);
    if (mesh.block_count() == 0) return canvas;
    const std::vector<double> areas = sorted_areas(mesh);
    const Range range = decades(areas);
    const Axes axes(upper_left, lower_right, range, {0, 100});
    draw_fraction_axis(canvas, axes, range);
    draw_decades(canvas, range, axes);
    canvas.polyline(step_curve(areas, axes, false), {line_colour(1), 1.4});
    canvas.polyline(step_curve(areas, axes, true), {line_colour(0), 1.8});
    const std::vector<LegendEntry> entries = {
        {"fraction of the area", std::nullopt, Stroke{line_colour(0), 1.8}, true},
        {"fraction of the number", std::nullopt, Stroke{line_colour(1), 1.4}, true}};
    const AreaSummary sizes = area_summary(block_areas(mesh));
    Labels labels(upper_left, lower_right);
    const Point legend = is_wide ? Point{upper_left.x + 12, upper_left.y + 10} : Point{upper_left.x, below};
    draw_legend(canvas, legend, "Blocks up to this size", entries, lower_right.x - legend.x);
    labels.reserve(legend, {legend.x + size_legend_width, legend.y + size_legend_height});
    for (const auto& [name, size, percent] :
         {std::tuple("D10", sizes.d10, 10.0), std::tuple("D50", sizes.d50, 50.0),
          std::tuple("D90", sizes.d90, 90.0)}) {
        const Point p = axes.to_page({std::log10(size), percent});
        canvas.polyline(std::vector<Point>{{p.x, lower_right.y}, p}, {grey, 0.7, {3, 2}});
        TextStyle letters{9, black, Anchor::end, Anchor::middle};
        letters.halo = white;
        labels.put(canvas, {{{p.x - 5, p.y - 7}, Anchor::end}, {{p.x + 5, p.y + 9}, Anchor::start}},
                   std::string(name) + " " + size_text(size), letters);
    }
    canvas.polygon(
        std::vector<Ring>{
            {upper_left, {lower_right.x, upper_left.y}, lower_right, {upper_left.x, lower_right.y}}},
        std::nullopt, Stroke{grey, 0.8});
    canvas.text({(upper_left.x + lower_right.x) / 2, lower_right.y + 34}, "block area (m\u00b2)",
                {10, black, Anchor::middle, Anchor::middle});
    return canvas;
}

}  // namespace rockslope::blockgen
