#include "history_table.hpp"

#include <algorithm>
#include <cmath>

#include "common/drawing/panel_page.hpp"
#include "common/drawing/told_apart.hpp"
#include "length_unit.hpp"
#include "line_points.hpp"

namespace rockslope {

namespace {

constexpr double rest = 1e-9;  // m, smaller displacements of a base count as no motion

/// One line of a panel: a name and the values over time, m.
struct Line {
    std::string name;
    std::size_t colour = 0;
    std::vector<double> values;
};

struct Panel {
    std::string title;  ///< of the ordinate, without its unit
    std::vector<Line> lines;
};

bool is_prescribed(const std::string& point) {
    return point.starts_with(prescribed_prefix);
}

const std::vector<double>& displacement(const HistoryTable& history, const std::string& point,
                                        const std::string& direction) {
    return history.columns[history.column(point + " u" + direction + " (m)")];
}

/// Displacements of the measured points in one direction, relative to the base if there is one.
Panel points_panel(const HistoryTable& history, const std::string& base, const std::string& direction) {
    Panel panel{base.empty() ? "displacement " + direction : direction + " from the base", {}};
    for (const std::string& point : history.points()) {
        if (is_prescribed(point)) continue;
        Line line{point, panel.lines.size(), displacement(history, point, direction)};
        if (!base.empty())
            for (std::size_t i = 0; i < line.values.size(); ++i)
                line.values[i] -= displacement(history, base, direction)[i];
        panel.lines.push_back(std::move(line));
    }
    return panel;
}

/// Displacements of the prescribed blocks in both directions, without directions that do not move.
Panel base_panel(const HistoryTable& history) {
    Panel panel{"displacement of the base", {}};
    for (const std::string& point : history.points()) {
        for (const char* direction : {"x", "y"}) {
            const std::vector<double>& values = displacement(history, point, direction);
            const bool moves =
                std::any_of(values.begin(), values.end(), [](double v) { return std::abs(v) > rest; });
            if (is_prescribed(point) && moves)
                panel.lines.push_back({point.substr(std::string(prescribed_prefix).size()) + " " + direction,
                                       6 + panel.lines.size(), values});
        }
    }
    return panel;
}

std::vector<Panel> panels_of(const HistoryTable& history) {
    const std::vector<std::string> points = history.points();
    const auto base = std::find_if(points.begin(), points.end(), is_prescribed);
    const std::string base_name = base == points.end() ? "" : *base;
    std::vector<Panel> panels = {points_panel(history, base_name, "x"), points_panel(history, base_name, "y"),
                                 base_panel(history)};
    std::erase_if(panels, [](const Panel& panel) { return panel.lines.empty(); });
    return panels;
}

/// Whether two panels have lines of the same names and colours: one legend is enough.
bool has_legend_of(const Panel& panel, const Panel& other) {
    return std::equal(panel.lines.begin(), panel.lines.end(), other.lines.begin(), other.lines.end(),
                      [](const Line& a, const Line& b) { return a.name == b.name && a.colour == b.colour; });
}

/// "time of stage 'shake' (s)", or "time (s)" of several stages.
std::string time_title(const HistoryTable& history) {
    const bool is_one = history.stage.front() == history.stage.back();
    return is_one ? "time of stage '" + history.stage.front() + "' (s)" : "time (s)";
}

/// The history with times from the beginning of its stage, if it has but one.
HistoryTable from_its_start(HistoryTable history) {
    if (history.stage.front() != history.stage.back()) return history;
    const double start = history.time.front();
    for (double& time : history.time) time -= start;
    return history;
}

void draw_panel(PanelPage& page, const HistoryTable& history, const std::vector<Panel>& panels,
                std::size_t number, bool has_legend) {
    const Panel& panel = panels[number];
    Canvas& canvas = page.canvas;
    double low = 0, high = 0;
    for (const Line& line : panel.lines) {
        low = std::min(low, *std::min_element(line.values.begin(), line.values.end()));
        high = std::max(high, *std::max_element(line.values.begin(), line.values.end()));
    }
    const LengthUnit unit = readable_unit(std::max(-low, high));
    const Range times{history.time.front(), std::max(history.time.back(), history.time.front() + 1e-9)};
    const Axes axes = page.axes(number, times, padded(low * unit.per_metre, high * unit.per_metre));
    axes.draw(canvas, number + 1 == panels.size() ? time_title(history) : "",
              panel.title + " (" + unit.name + ")", true);
    canvas.clip(axes.upper_left(), axes.lower_right());
    std::vector<LegendEntry> entries;
    std::vector<std::vector<Point>> drawn;
    for (const Line& line : panel.lines) {
        std::vector<Point> points = line_points(history.time, line.values, unit.per_metre);
        for (Point& point : points) point = axes.to_page(point);
        const Stroke stroke = told_apart({line_colour(line.colour), 1.1}, points, drawn);
        canvas.polyline(points, stroke);
        drawn.push_back(points);
        LegendEntry entry;
        entry.text = line.name;
        entry.stroke = stroke;
        entry.is_line = true;
        entries.push_back(entry);
    }
    canvas.unclip();
    if (has_legend) page.draw_legend(number, entries);
}

}  // namespace

Canvas draw_history(const HistoryTable& all_stages, const PageStyle& style) {
    const HistoryTable history = from_its_start(without_reset_stages(all_stages));
    const std::vector<Panel> panels = panels_of(history);
    PanelLayout layout{.title = "Displacement of the recorded points", .panels = panels.size()};
    for (std::size_t i = 0; i < panels.size(); ++i) {
        layout.legends.emplace_back();
        if (i > 0 && has_legend_of(panels[i], panels[i - 1])) continue;
        for (const Line& line : panels[i].lines) layout.legends.back().push_back(line.name);
    }
    PanelPage page(layout, style);
    for (std::size_t i = 0; i < panels.size(); ++i)
        draw_panel(page, history, panels, i, !layout.legends[i].empty());
    return std::move(page.canvas);
}

}  // namespace rockslope
