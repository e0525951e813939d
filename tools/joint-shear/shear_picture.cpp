#include "shear_picture.hpp"

#include <algorithm>
#include <cmath>

#include "common/drawing/axes.hpp"

namespace rockslope {

namespace {

constexpr double page_width = 640, panel_height = 220, panel_gap = 20, left = 62, right = 140, top = 34;
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

}  // namespace

Canvas draw_shear_test(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows,
                       const std::optional<ComparedPoints>& compared) {
    const dda::ShearTable* measured = compared ? &compared->table : nullptr;
    const std::vector<Panel> panels = panels_of(input.test, measured);
    const auto count = static_cast<double>(panels.size());
    Canvas canvas(page_width, top + count * panel_height + (count - 1) * panel_gap + 44);
    canvas.text({left, top - 12}, "Direct shear of " + input.material,
                {11, black, Anchor::start, Anchor::start, true});
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
        const double upper = top + static_cast<double>(k) * (panel_height + panel_gap);
        const Axes axes({left, upper}, {page_width - right, upper + panel_height}, x.range(), y.range());
        axes.draw(canvas, k + 1 == panels.size() ? "displacement (mm)" : "", panel.title, true);
        draw_panel(canvas, axes, panel, rows, measured ? &measured->displacement : nullptr);
    }
    std::vector<LegendEntry> entries(measured ? 2 : 1);
    entries[0].text = compared && compared->origin == "blocks" ? "joint law" : "computed";
    entries[0].stroke = Stroke{line_colour(0), 1.1};
    entries[0].is_line = true;
    if (measured) {
        entries[1].text = compared->origin == "blocks" ? "computed (blocks)" : "measured (circles)";
        entries[1].stroke = Stroke{line_colour(measured_colour), 0.7};
        entries[1].is_line = true;
    }
    draw_legend(canvas, {page_width - right + 14, top + 4}, "", entries);
    return canvas;
}

}  // namespace rockslope
