#include "study/picture/fragility_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "common/base/text.hpp"
#include "common/drawing/axes.hpp"

namespace rockslope::study {

namespace {

constexpr double plot_width = 460, plot_height = 320;  // pt
constexpr Point upper_left{56, 34}, lower_right{444, 274};
constexpr int curve_points = 200;
constexpr std::size_t rows_for_share = 3;  ///< rows of one intensity whose share of failures is drawn

Colour curve_colour() {
    return line_colour(0);
}

Colour faded(Colour colour, double opacity) {
    colour.opacity = opacity;
    return colour;
}

/// From zero to a round number above the largest intensity.
Range intensity_axis(const Fragility& fragility) {
    double largest = 0;
    for (const FragilityPoint& point : fragility.points) largest = std::max(largest, point.intensity);
    return {0, 1.08 * largest};
}

void draw_band(Canvas& canvas, const Axes& axes, const CurveBand& band, double largest) {
    Ring outline, back;
    for (int k = 1; k <= curve_points; ++k) {
        const double x = largest * k / curve_points;
        const auto [lower, upper] = band.probability(x);
        outline.push_back(axes.to_page({x, upper}));
        back.push_back(axes.to_page({x, lower}));
    }
    outline.insert(outline.end(), back.rbegin(), back.rend());
    canvas.polygon(std::span(&outline, 1), faded(curve_colour(), 0.2), std::nullopt);
}

void draw_curve(Canvas& canvas, const Axes& axes, const LognormalCurve& curve, double largest) {
    std::vector<Point> line = {axes.to_page({0, 0})};
    for (int k = 1; k <= curve_points; ++k) {
        const double x = largest * k / curve_points;
        line.push_back(axes.to_page({x, curve.probability(x)}));
    }
    canvas.polyline(line, {curve_colour(), 1.8});
}

/// Each row as a small circle at 0 or 1, spread a little over the height so that equal ones are seen.
void draw_rows(Canvas& canvas, const Axes& axes, const Fragility& fragility) {
    std::map<std::pair<double, bool>, int> count;
    for (const FragilityPoint& point : fragility.points) {
        const int number = count[{point.intensity, point.has_failed}]++;
        const double shift = 0.004 * (number % 8);
        canvas.circle(axes.to_page({point.intensity, point.has_failed ? 1.0 - shift : shift}), 1.6,
                      faded(point.has_failed ? line_colour(1) : grey, 0.6), std::nullopt);
    }
}

/// The share of failures where several rows have one intensity.
void draw_shares(Canvas& canvas, const Axes& axes, const Fragility& fragility) {
    std::map<double, std::pair<double, std::size_t>> shares;
    for (const FragilityPoint& point : fragility.points) {
        auto& [failed, all] = shares[point.intensity];
        failed += point.has_failed ? 1 : 0;
        ++all;
    }
    for (const auto& [intensity, share] : shares)
        if (share.second >= rows_for_share)
            canvas.circle(axes.to_page({intensity, share.first / static_cast<double>(share.second)}), 3.2,
                          white, Stroke{black, 1.1});
}

std::string short_figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string title_of(const Fragility& fragility) {
    const std::string question =
        fragility.measure_heading + " beyond " + short_figure(fragility.request.limit);
    if (!fragility.curve) return question + ": no curve";
    return question + ": median " + short_figure(fragility.curve->median) + ", dispersion " +
           short_figure(fragility.curve->dispersion);
}

void draw_title(Canvas& canvas, const std::string& title) {
    canvas.text({upper_left.x, 22}, title, {10.5, black, Anchor::start, Anchor::start, true});
}

double number_or(const std::string& text, double fallback) {
    return parse_number(text).value_or(fallback);
}

}  // namespace

Canvas draw_fragility(const Fragility& fragility) {
    Canvas canvas(plot_width, plot_height);
    const Range intensities = intensity_axis(fragility);
    const Axes axes(upper_left, lower_right, intensities, {0, 1});
    if (fragility.band) draw_band(canvas, axes, *fragility.band, intensities.high);
    draw_rows(canvas, axes, fragility);
    if (fragility.curve) draw_curve(canvas, axes, *fragility.curve, intensities.high);
    draw_shares(canvas, axes, fragility);
    axes.draw(canvas, fragility.intensity_heading, "probability of failure");
    draw_title(canvas, title_of(fragility));
    return canvas;
}

Canvas draw_convergence(const Fragility& fragility, const TextTable& convergence) {
    Canvas canvas(plot_width, plot_height);
    double largest = 0;
    for (const auto& row : convergence.rows)
        largest = std::max(
            {largest, number_or(row[1], 0), std::min(number_or(row[3], 0), 4 * number_or(row[1], 0))});
    if (!(largest > 0)) largest = 1;
    const Axes axes(upper_left, lower_right, {1, static_cast<double>(convergence.rows.size()) + 2},
                    {0, 1.08 * largest});
    canvas.clip(axes.upper_left(), axes.lower_right());
    std::vector<Point> medians;
    for (const auto& row : convergence.rows) {
        const double count = number_or(row[0], 0);
        if (row[1].empty()) continue;
        const Point median = axes.to_page({count, number_or(row[1], 0)});
        medians.push_back(median);
        if (row[2].empty()) continue;
        canvas.polyline(std::vector<Point>{axes.to_page({count, number_or(row[2], 0)}),
                                           axes.to_page({count, number_or(row[3], 0)})},
                        {faded(curve_colour(), 0.5), 3});
    }
    canvas.polyline(medians, {curve_colour(), 1.4});
    for (const Point& median : medians) canvas.circle(median, 2.6, curve_colour(), std::nullopt);
    canvas.unclip();
    const std::string groups =
        fragility.groupings.empty() ? "rows" : "groups of " + fragility.groupings.front().name;
    axes.draw(canvas, "number of " + groups, "median, " + fragility.intensity_heading, true);
    draw_title(canvas, fragility.measure_heading + " beyond " + short_figure(fragility.request.limit) +
                           ": the median and its band");
    return canvas;
}

Canvas draw_sensitivity(const SensitivityStudy& study) {
    constexpr double bar_height = 14, gap = 12, bars_left = 130;
    const auto count = static_cast<double>(study.bars.size());
    const double bottom = upper_left.y + count * (bar_height + gap) + gap;
    Canvas canvas(plot_width, bottom + 58);
    double low = 0, high = 0;
    if (!study.bars.empty()) low = high = study.bars.front().from;
    for (const SensitivityStudy::Bar& bar : study.bars) {
        low = std::min({low, bar.low, bar.high});
        high = std::max({high, bar.low, bar.high});
    }
    if (!(high > low)) high = low + 1;
    const double margin = 0.04 * (high - low);
    const Axes axes({bars_left, upper_left.y}, {lower_right.x, bottom},
                    {low < 0 ? low - margin : low, high + margin}, {0, 1});
    for (std::size_t k = 0; k < study.bars.size(); ++k) {
        const SensitivityStudy::Bar& bar = study.bars[k];
        const double y = upper_left.y + gap + static_cast<double>(k) * (bar_height + gap);
        const double heights[] = {0.5, 0.5};
        double top = y;
        for (const bool is_high : {false, true}) {
            const double from = axes.to_page({bar.from, 0}).x,
                         to = axes.to_page({is_high ? bar.high : bar.low, 0}).x;
            const double height = bar_height * heights[is_high ? 1 : 0];
            const Ring ring = {{std::min(from, to), top},
                               {std::max(from, to), top},
                               {std::max(from, to), top + height},
                               {std::min(from, to), top + height}};
            canvas.polygon(std::span(&ring, 1), line_colour(is_high ? 1 : 0), std::nullopt);
            top += height;
        }
        canvas.text({bars_left - 8, y + bar_height - 3}, bar.factor, {9, black, Anchor::end});
    }
    std::vector<double> ticks = round_ticks({low, high}, 5);
    for (const double tick : ticks) {
        const double x = axes.to_page({tick, 0}).x;
        canvas.polyline(std::vector<Point>{{x, upper_left.y}, {x, bottom}}, {pale_grey, 0.6});
        canvas.text({x, bottom + 14}, short_figure(tick), {8.5, black, Anchor::middle});
    }
    canvas.text({(bars_left + lower_right.x) / 2, bottom + 32}, study.measure_heading + ", " + study.kind,
                {9, black, Anchor::middle});
    double x = bars_left;
    for (const bool is_high : {false, true}) {
        const Ring box = {{x, bottom + 38}, {x + 9, bottom + 38}, {x + 9, bottom + 47}, {x, bottom + 47}};
        canvas.polygon(std::span(&box, 1), line_colour(is_high ? 1 : 0), std::nullopt);
        const std::string& title = is_high ? study.high_title : study.low_title;
        canvas.text({x + 13, bottom + 46}, title, {8.5});
        x += 13 + canvas.text_width(title, {8.5}) + 18;
    }
    draw_title(canvas, study.kind + " of " + study.measure_heading);
    return canvas;
}

}  // namespace rockslope::study
