#include "blockgen/picture/stereonet_picture.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <set>
#include <utility>

#include "blockgen/picture/density_contours.hpp"
#include "blockgen/picture/equal_area.hpp"
#include "common/base/degree.hpp"
#include "common/base/text.hpp"
#include "common/drawing/axes.hpp"

namespace rockslope::blockgen {

namespace {

using std::numbers::pi;

constexpr double net_width = 400, net_margin = 34, net_legend_row = 16, net_legend_top = 30;

/// The page round the net.
class NetPage {
  public:
    explicit NetPage(double width) : middle_(width / 2), radius_(width / 2 - net_margin) {}

    /// The place of a point of the unit circle, x to the east and y to the north.
    Point at(const Point& p) const { return {middle_ + radius_ * p.x, middle_ - radius_ * p.y}; }
    /// The place in a direction clockwise from north, so far from the centre.
    Point at(double radius, double azimuth) const {
        return {middle_ + radius * std::sin(azimuth), middle_ - radius * std::cos(azimuth)};
    }
    Point at(const StereonetPlane& plane) const {
        return at(equal_area(downward_pole(plane.dip, plane.dip_direction)));
    }
    double radius() const { return radius_; }
    void draw(Canvas& canvas, const std::vector<Point>& curve, const Stroke& stroke) const {
        std::vector<Point> line;
        for (const Point& p : curve) line.push_back(at(p));
        canvas.polyline(line, stroke);
    }

  private:
    double middle_, radius_;
};

/// Schmidt's net by ten degrees, its rim, and the points of the compass.
void draw_net(Canvas& canvas, const NetPage& page) {
    for (int k = 1; k < 18; ++k) {
        const double angle = 10 * degree * k, dip = k <= 9 ? angle : pi - angle;
        page.draw(canvas, small_circle(angle), {pale_grey, 0.5});
        page.draw(canvas, great_circle(dip, k <= 9 ? pi / 2 : -pi / 2), {pale_grey, 0.5});
    }
    canvas.circle(page.at(Point{0, 0}), page.radius(), std::nullopt, Stroke{black, 1});
    for (int k = 0; k < 36; ++k) {
        const double azimuth = 10 * degree * k;
        canvas.polyline(
            std::vector<Point>{page.at(page.radius(), azimuth), page.at(page.radius() + 3, azimuth)},
            {black, 0.6});
    }
    const char* const names[] = {"N", "E", "S", "W"};
    for (int k = 0; k < 4; ++k)
        canvas.text(page.at(page.radius() + 13, pi / 2 * k), names[k],
                    {11, black, Anchor::middle, Anchor::middle});
}

/// Text of a direction in whole degrees with three digits, as on a compass.
std::string compass_text(double azimuth) {
    char text[32];
    const long degrees = std::lround(azimuth / degree) % 360;
    std::snprintf(text, sizeof text, "%03ld", degrees < 0 ? degrees + 360 : degrees);
    return text;
}

Stroke section_stroke() {
    return {black, 1.2, {6, 3}};
}

/// The line of the section, with its name beside it along the x axis.
void draw_section(Canvas& canvas, const NetPage& page, double azimuth) {
    canvas.polyline(std::vector<Point>{page.at(page.radius(), azimuth + pi), page.at(page.radius(), azimuth)},
                    section_stroke());
    TextStyle letters{8, black, Anchor::middle, Anchor::start};
    letters.halo = white;
    letters.angle = std::remainder(pi / 2 - azimuth, pi);
    const Point place = page.at(0.78 * page.radius(), azimuth);
    // Above the line as it is read.
    canvas.text({place.x - 4 * std::sin(letters.angle), place.y - 4 * std::cos(letters.angle)},
                "x " + compass_text(azimuth) + "\u00b0", letters);
}

/// Poles nearer to each other than this are drawn once, pt.
constexpr double pole_spacing = 0.4;

void draw_poles(Canvas& canvas, const NetPage& page, const StereonetSet& set, const Colour& colour) {
    std::set<std::pair<std::int64_t, std::int64_t>> drawn;
    for (const StereonetPlane& plane : set.planes) {
        const Point p = page.at(plane);
        if (drawn.emplace(std::llround(p.x / pole_spacing), std::llround(p.y / pole_spacing)).second)
            canvas.circle(p, 1.8, colour, Stroke{white, 0.3});
    }
}

/// Contours of the density of all poles, and what the legend says of them.
struct DrawnDensity {
    std::vector<DensityContour> contours;
    std::string levels, unit, method;  ///< lines of the legend, short enough for a narrow page

    explicit DrawnDensity(const AxisDensity& density) : contours(density_contours(density)) {
        for (const DensityContour& contour : contours)
            levels += (levels.empty() ? "contours " : ", ") + shortest_text(contour.density);
        if (levels.empty()) levels = "no contours";
        char text[96];
        std::snprintf(text, sizeof text, "%% of poles per 1 %% of area, max. %.3g", density.peak().density);
        unit = text;
        std::snprintf(text, sizeof text, "exponential Kamb, uniform 1 \u00b1 %.2f",
                      density.uniform_deviation());
        method = text;
    }
    /// From pale to dark.
    Stroke stroke(std::size_t level) const {
        const double weight = static_cast<double>(level + 1) / static_cast<double>(contours.size());
        return {blend(Colour{0.62, 0.62, 0.65}, black, weight), 0.9};
    }
    void draw(Canvas& canvas, const NetPage& page) const {
        for (std::size_t level = 0; level < contours.size(); ++level)
            for (const std::vector<Point>& line : contours[level].lines)
                page.draw(canvas, line, stroke(level));
    }
};

/// Nothing for a net without poles.
std::optional<DrawnDensity> density_of(const Stereonet& net) {
    std::vector<SpaceDirection> poles;
    for (const StereonetSet& set : net.sets)
        for (const StereonetPlane& plane : set.planes)
            poles.push_back(downward_pole(plane.dip, plane.dip_direction));
    if (poles.empty()) return std::nullopt;
    return DrawnDensity(AxisDensity(poles));
}

void draw_mean(Canvas& canvas, const NetPage& page, const StereonetSet& set, const Colour& colour) {
    page.draw(canvas, great_circle(set.mean.dip, set.mean.dip_direction), {colour, 1.3});
    canvas.circle(page.at(set.mean), 5, std::nullopt, Stroke{white, 2.6});
    canvas.circle(page.at(set.mean), 5, std::nullopt, Stroke{colour, 1.4});
}

/// Figures before the name, which is shortened where it is too long for the page.
std::string legend_text(const StereonetSet& set) {
    char text[96];
    std::snprintf(text, sizeof text, "%02ld/%s, n %zu", std::lround(set.mean.dip / degree),
                  compass_text(set.mean.dip_direction).c_str(), set.planes.size());
    std::string line = text;
    if (set.fisher_k) {
        std::snprintf(text, sizeof text, ", K %.3g", *set.fisher_k);
        line += text;
    } else if (set.planes.size() > 1) {
        line += ", all parallel";
    }
    return line + "  " + set.name;
}

std::vector<LegendEntry> legend_entries(const Stereonet& net, const std::optional<DrawnDensity>& density) {
    std::vector<LegendEntry> entries;
    for (std::size_t k = 0; k < net.sets.size(); ++k) {
        LegendEntry entry{legend_text(net.sets[k]), line_colour(k), std::nullopt, false};
        entry.is_circle = true;
        entries.push_back(entry);
    }
    entries.push_back({"section, x towards " + compass_text(net.section_azimuth) + "\u00b0", std::nullopt,
                       section_stroke(), true});
    if (density) {
        entries.push_back({density->levels, std::nullopt, Stroke{grey, 0.9}, true});
        entries.push_back({density->unit});
        entries.push_back({density->method});
    }
    if (net.without_planes.empty()) return entries;
    std::string names;
    for (const std::string& name : net.without_planes) names += (names.empty() ? "" : ", ") + name;
    entries.push_back({"not drawn: " + names});
    return entries;
}

}  // namespace

Canvas draw_stereonet(const Stereonet& net, const PageStyle& style) {
    const double width = style.width_in_units(net_width);
    const std::optional<DrawnDensity> density = density_of(net);
    const std::vector<LegendEntry> entries = legend_entries(net, density);
    Canvas canvas(width, width + net_legend_top + net_legend_row * static_cast<double>(entries.size()),
                  style);
    const NetPage page(width);
    draw_net(canvas, page);
    draw_section(canvas, page, net.section_azimuth);
    for (std::size_t k = 0; k < net.sets.size(); ++k) draw_poles(canvas, page, net.sets[k], line_colour(k));
    if (density) density->draw(canvas, page);
    for (std::size_t k = 0; k < net.sets.size(); ++k) draw_mean(canvas, page, net.sets[k], line_colour(k));
    draw_legend(canvas, {net_margin, width},
                "Poles of planes: dip/dip direction, lower hemisphere, equal area", entries,
                width - 2 * net_margin);
    return canvas;
}

}  // namespace rockslope::blockgen
