#include "shear_picture.hpp"

#include <algorithm>
#include <cmath>

#include "common/drawing/panel_page.hpp"

namespace rockslope {

namespace {

constexpr double shear_panel_height = 220;
constexpr std::size_t measured_colour = 1;

struct Panel {
    std::string title;
    double dda::ShearTestRow::*computed;
    const std::vector<double>* measured;
    double factor;  ///< from SI to the unit in the title
};

Range padded(double low, double high) {
    const double size = high > low ? high - low : std::max(std::abs(high), 1e-9);
    return {low - 0.05 * size, high + 0.05 * size};
}

class ValueRange {
  public:
    void take(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    Range range() const { return padded(low_, high_); }

  private:
    double low_ = 0, high_ = 0;
};

/// Every how many points a circle is drawn: the points of a run are many, and would hide the curve.
std::size_t stride_of(std::size_t points) {
    constexpr std::size_t most_circles = 150;
    return std::max<std::size_t>(1, points / most_circles);
}

void draw_panel(Canvas& canvas, const Axes& axes, const Panel& panel,
                const std::vector<dda::ShearTestRow>& rows, const std::vector<double>* displacement) {
    canvas.clip(axes.upper_left(), axes.lower_right());
    std::vector<Point> line;
    for (const dda::ShearTestRow& row : rows)
        line.push_back(axes.to_page(Point{row.displacement * 1e3, row.*panel.computed * panel.factor}));
    canvas.polyline(line, {line_colour(0), 1.1});
    if (panel.measured)
        for (std::size_t k = 0; k < panel.measured->size(); k += stride_of(panel.measured->size()))
            canvas.circle(axes.to_page(Point{(*displacement)[k] * 1e3, (*panel.measured)[k] * panel.factor}),
                          1.8, std::nullopt, Stroke{line_colour(measured_colour), 0.7});
    canvas.unclip();
}

std::vector<Panel> panels_of(const dda::ShearTest& test, const dda::ShearTable* measured) {
    const auto column = [&](const std::vector<double>& values) {
        return measured && !values.empty() ? &values : nullptr;
    };
    static const std::vector<double> none;
    std::vector<Panel> panels = {
        {"shear stress (MPa)", &dda::ShearTestRow::shear_stress,
         column(measured ? measured->shear_stress : none), 1e-6},
        {"dilation (mm)", &dda::ShearTestRow::dilation, column(measured ? measured->dilation : none), 1e3}};
    if (test.boundary != dda::NormalBoundary::constant_stress)
        panels.push_back({"normal stress (MPa)", &dda::ShearTestRow::normal_stress,
                          column(measured ? measured->normal_stress : none), 1e-6});
    return panels;
}

std::vector<LegendEntry> legend_of(const std::optional<ComparedPoints>& compared) {
    const bool is_of_blocks = compared && compared->origin == "blocks";
    std::vector<LegendEntry> entries = {
        {is_of_blocks ? "joint law" : "computed", std::nullopt, Stroke{line_colour(0), 1.1}, true}};
    if (compared) {
        LegendEntry points{is_of_blocks ? "computed (blocks)" : "measured"};
        points.stroke = Stroke{line_colour(measured_colour), 0.7};
        points.is_circle = true;
        entries.push_back(points);
    }
    return entries;
}

}  // namespace

Canvas draw_shear_test(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows,
                       const std::optional<ComparedPoints>& compared, const PageStyle& style) {
    const dda::ShearTable* measured = compared ? &compared->table : nullptr;
    const std::vector<Panel> panels = panels_of(input.test, measured);
    const std::vector<LegendEntry> legend = legend_of(compared);
    PanelPage page({.panel_height = shear_panel_height,
                    .title = "Direct shear of " + input.material,
                    .panels = panels.size(),
                    .legends = {names_of(legend)}},
                   style);
    ValueRange x;
    for (const dda::ShearTestRow& row : rows) x.take(row.displacement * 1e3);
    if (measured)
        for (const double displacement : measured->displacement) x.take(displacement * 1e3);
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const Panel& panel = panels[k];
        ValueRange y;
        for (const dda::ShearTestRow& row : rows) y.take(row.*panel.computed * panel.factor);
        if (panel.measured)
            for (const double value : *panel.measured) y.take(value * panel.factor);
        const Axes axes = page.axes(k, x.range(), y.range());
        axes.draw(page.canvas, k + 1 == panels.size() ? "displacement (mm)" : "", panel.title, true);
        draw_panel(page.canvas, axes, panel, rows, measured ? &measured->displacement : nullptr);
    }
    page.draw_legend(0, legend);
    return std::move(page.canvas);
}

}  // namespace rockslope
