#include "joint_history.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/drawing/panel_page.hpp"
#include "common/drawing/told_apart.hpp"
#include "length_unit.hpp"
#include "line_points.hpp"

namespace rockslope {

namespace {

constexpr double joint_panel_height = 170;
/// Fraction of the displacement below which dilation is not drawn: it is the compliance of the springs.
constexpr double min_drawn_dilation = 1e-3;

struct Line {
    const std::vector<double>* time;
    std::vector<double> values;
    std::size_t colour = 0;
    bool dashed = false;
};

struct Panel {
    std::string title;
    std::vector<Line> lines;
};

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}

double largest_of(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

/// Friction angles, deg; the previous angle while the joint is open.
std::vector<double> friction_angles(const JointHistory& run) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < run.strength.size(); ++k) {
        const bool is_compressed = run.normal_stress[k] > 0;
        angles.push_back(is_compressed
                             ? std::atan2(run.strength[k], run.normal_stress[k]) * 180 / std::numbers::pi
                         : k > 0 ? angles.back()
                                 : 0);
    }
    return angles;
}

Panel length_panel(const std::string& title, std::vector<double> JointHistory::*column,
                   std::span<const JointHistory> runs, std::span<const JointHistory> references) {
    double largest = 0;
    for (const auto& some : {runs, references})
        for (const JointHistory& run : some) largest = std::max(largest, largest_of(run.*column));
    const LengthUnit unit = readable_unit(largest);
    Panel panel{title + " (" + unit.name + ")", {}};
    for (std::size_t k = 0; k < runs.size(); ++k)
        panel.lines.push_back({&runs[k].time, scaled(runs[k].*column, unit.per_metre), k, false});
    for (std::size_t k = 0; k < references.size(); ++k)
        panel.lines.push_back({&references[k].time, scaled(references[k].*column, unit.per_metre), k, true});
    return panel;
}

std::vector<Panel> panels_of(std::span<const JointHistory> runs, std::span<const JointHistory> references) {
    std::vector<Panel> panels = {length_panel("displacement", &JointHistory::displacement, runs, references)};
    const auto any = [&](const auto& condition) { return std::any_of(runs.begin(), runs.end(), condition); };
    if (any([](const JointHistory& run) {
            return largest_of(run.dilation) > min_drawn_dilation * largest_of(run.displacement);
        }))
        panels.push_back(length_panel("dilation", &JointHistory::dilation, runs, {}));
    Panel friction{"friction angle (deg)", {}}, reversals{"changes of direction", {}};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        friction.lines.push_back({&runs[k].time, friction_angles(runs[k]), k, false});
        reversals.lines.push_back({&runs[k].time, runs[k].reversals, k, false});
    }
    panels.push_back(std::move(friction));
    if (any([](const JointHistory& run) { return largest_of(run.reversals) > 0; }))
        panels.push_back(std::move(reversals));
    for (Panel& panel : panels)
        std::erase_if(panel.lines, [](const Line& line) { return line.values.empty(); });
    std::erase_if(panels, [](const Panel& panel) { return panel.lines.empty(); });
    return panels;
}

Range times_of(const std::vector<Panel>& panels) {
    Range range{1e300, -1e300};
    for (const Line& line : panels.front().lines) {
        range.low = std::min(range.low, line.time->front());
        range.high = std::max(range.high, line.time->back());
    }
    range.high = std::max(range.high, range.low + 1e-9);
    return range;
}

void draw_line(Canvas& canvas, const std::vector<Point>& points, const Stroke& stroke, bool dashed) {
    if (!dashed) {
        canvas.polyline(points, stroke);
        return;
    }
    constexpr std::size_t dash = 6;  // length, pt
    double length = 0;
    std::vector<Point> piece;
    bool drawn = true;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (k > 0) length += std::hypot(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y);
        if (drawn) piece.push_back(points[k]);
        if (length < dash) continue;
        if (piece.size() > 1) canvas.polyline(piece, stroke);
        piece.clear();
        drawn = !drawn;
        if (drawn) piece.push_back(points[k]);
        length = 0;
    }
    if (piece.size() > 1) canvas.polyline(piece, stroke);
}

Stroke stroke_of(std::size_t colour, bool dashed) {
    return {dashed ? black : line_colour(colour), dashed ? 0.9 : 1.2};
}

void draw_panel(PanelPage& page, const std::vector<Panel>& panels, std::size_t number, const Range& times) {
    const Panel& panel = panels[number];
    Canvas& canvas = page.canvas;
    double low = 0, high = 0;
    for (const Line& line : panel.lines) {
        low = std::min(low, *std::min_element(line.values.begin(), line.values.end()));
        high = std::max(high, *std::max_element(line.values.begin(), line.values.end()));
    }
    const Axes axes = page.axes(number, times, padded(low, high));
    axes.draw(canvas, number + 1 == panels.size() ? "time since the reset of displacements (s)" : "",
              panel.title, true);
    canvas.clip(axes.upper_left(), axes.lower_right());
    std::vector<std::vector<Point>> drawn;
    for (const Line& line : panel.lines) {
        std::vector<Point> points = line_points(*line.time, line.values, 1);
        for (Point& point : points) point = axes.to_page(point);
        draw_line(canvas, points, told_apart(stroke_of(line.colour, line.dashed), points, drawn),
                  line.dashed);
        drawn.push_back(points);
    }
    canvas.unclip();
}

}  // namespace

Canvas draw_joint_histories(const std::string& joint, std::span<const JointHistory> runs,
                            std::span<const JointHistory> references, const PageStyle& style) {
    const std::vector<Panel> panels = panels_of(runs, references);
    std::vector<LegendEntry> entries;
    for (std::size_t k = 0; k < runs.size(); ++k)
        entries.push_back({runs[k].label, std::nullopt, stroke_of(k, false), true});
    for (std::size_t k = 0; k < references.size(); ++k)
        entries.push_back({references[k].label + " (dashed)", std::nullopt, stroke_of(k, true), true});
    PanelPage page({.panel_height = joint_panel_height,
                    .title = "Joint '" + joint + "'",
                    .panels = panels.size(),
                    .legends = {names_of(entries)}},
                   style);
    for (std::size_t k = 0; k < panels.size(); ++k) draw_panel(page, panels, k, times_of(panels));
    page.draw_legend(0, entries);
    return std::move(page.canvas);
}

}  // namespace rockslope
