#include "record_picture.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "common/drawing/fitted_text.hpp"
#include "common/drawing/panel_page.hpp"
#include "common/drawing/told_apart.hpp"
#include "record/measures.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope {

namespace {

/// Upper end of an axis for the largest magnitude of the curves, with a margin of 10 %.
double axis_end(const std::vector<PictureCurve>& curves) {
    double largest = 1e-9;
    for (const PictureCurve& curve : curves) largest = std::max(largest, record::largest_magnitude(curve.y));
    return 1.1 * largest;
}

/// Range of the values and zero, with a margin of 5 %.
Range range_of(const std::vector<PictureCurve>& curves) {
    double low = 0, high = 1e-9;
    for (const PictureCurve& curve : curves) {
        low = std::min(low, *std::min_element(curve.y.begin(), curve.y.end()));
        high = std::max(high, *std::max_element(curve.y.begin(), curve.y.end()));
    }
    const double margin = 0.05 * (high - low);
    return {low - margin, high + margin};
}

/// A single curve has the colour of its panel; several curves have one colour each.
std::size_t colour_of(const std::vector<PictureCurve>& curves, std::size_t k, std::size_t panel) {
    return curves.size() == 1 ? panel : k;
}

void draw_curves(Canvas& canvas, const Axes& axes, const std::vector<PictureCurve>& curves,
                 std::size_t panel) {
    std::vector<std::vector<Point>> drawn;
    canvas.clip(axes.upper_left(), axes.lower_right());
    for (std::size_t number = 0; number < curves.size(); ++number) {
        const PictureCurve& curve = curves[number];
        std::vector<Point> line;
        for (std::size_t k = 0; k < curve.x.size(); ++k)
            line.push_back(axes.to_page(Point{curve.x[k], curve.y[k]}));
        canvas.polyline(line, told_apart({line_colour(colour_of(curves, number, panel)), 0.7}, line, drawn));
        drawn.push_back(std::move(line));
    }
    canvas.unclip();
}

std::vector<LegendEntry> legend_of(const std::vector<PictureCurve>& curves) {
    std::vector<LegendEntry> entries;
    for (std::size_t k = 0; k < curves.size(); ++k)
        entries.push_back({curves[k].name, std::nullopt, Stroke{line_colour(k), 1.1}, true});
    return entries;
}

PictureCurve over_time(const NamedRecord& record, const std::vector<double>& values, double factor) {
    PictureCurve curve{record.name, {}, values};
    for (double& value : curve.y) value *= factor;
    for (std::size_t k = 0; k < values.size(); ++k)
        curve.x.push_back(static_cast<double>(k) * record.record.step);
    return curve;
}

PictureCurve spectrum_curve(const NamedRecord& record) {
    PictureCurve curve{record.name, {}, {}};
    for (int k = 1; k <= 200; ++k) curve.x.push_back(0.02 * k);
    for (const record::SpectralOrdinate& ordinate : record::response_spectrum(record.record, curve.x, 0.05))
        curve.y.push_back(ordinate.absolute_acceleration / record::standard_gravity);
    return curve;
}

/// Where the histories and the spectra of records are: side by side, or below each other on a narrow page.
struct RecordLayout {
    static constexpr double left = 72, top = 38, right = 20, least_wide_page = 560;

    double width, panel, step;  ///< of the page; heights of a panel, and from one to the next
    double histories_end;       ///< x
    Point spectra_start, spectra_end;

    explicit RecordLayout(double page) : width(page) {
        const bool is_wide = page >= least_wide_page;
        histories_end = is_wide ? 0.585 * page : page - right;
        panel = is_wide ? 165 : std::min(165.0, 0.6 * (histories_end - left));
        step = panel + 30;
        const double below = top + 3 * step + 20;
        spectra_start = is_wide ? Point{0.682 * page, top} : Point{left, below};
        spectra_end = {page - right, is_wide ? top + 2 * step + panel : below + 1.3 * panel};
    }
    Axes history(std::size_t k, const Range& x, const Range& y) const {
        const double upper = top + step * static_cast<double>(k);
        return {{left, upper}, {histories_end, upper + panel}, x, y};
    }
    double legend_start() const { return std::max(spectra_end.y, top + 2 * step + panel) + 44; }
};

}  // namespace

Canvas record_picture(const std::vector<NamedRecord>& records, const std::string& title,
                      const PageStyle& style) {
    std::array<std::vector<PictureCurve>, 3> histories;
    std::vector<PictureCurve> spectra;
    double duration = 0;
    for (const NamedRecord& record : records) {
        const record::GroundMotion motion = record::integrate(record.record);
        histories[0].push_back(over_time(record, record.record.values, 1 / record::standard_gravity));
        histories[1].push_back(over_time(record, motion.velocity, 1));
        histories[2].push_back(over_time(record, motion.displacement, 1));
        spectra.push_back(spectrum_curve(record));
        duration = std::max(duration, record.record.duration());
    }
    const std::vector<std::string> titles = {"acceleration (g)", "velocity (m/s)", "displacement (m)"};
    const RecordLayout layout(style.width_in_units(760));
    const std::vector<LegendEntry> legend =
        records.size() > 1 ? legend_of(spectra) : std::vector<LegendEntry>{};
    Canvas canvas(layout.width, layout.legend_start() + 16 * static_cast<double>(legend.size()), style);
    const TextStyle heading{.size = 11, .bold = true};
    canvas.text({16, 22}, shortened(canvas, title, heading, layout.width - 32), heading);
    for (std::size_t k = 0; k < histories.size(); ++k) {
        const double end = axis_end(histories[k]);
        const Axes axes = layout.history(k, Range{0, duration}, Range{-end, end});
        axes.draw(canvas, k + 1 == histories.size() ? "time (s)" : "", titles[k], true);
        draw_curves(canvas, axes, histories[k], k);
    }
    const Axes axes(layout.spectra_start, layout.spectra_end, Range{0, 4}, Range{0, axis_end(spectra)});
    axes.draw(canvas, "period (s)", "acceleration, 5 % damping (g)", true);
    draw_curves(canvas, axes, spectra, 3);
    for (std::size_t k = 0; k < legend.size(); ++k)
        draw_legend_entry(canvas, {RecordLayout::left, layout.legend_start() + 16 * static_cast<double>(k)},
                          legend[k], layout.width - RecordLayout::left - 40);
    return canvas;
}

Canvas displacement_picture(const std::vector<PictureCurve>& x, const std::vector<PictureCurve>& y,
                            const std::string& title, const PageStyle& style) {
    double duration = 1e-9;
    for (const PictureCurve& curve : x) duration = std::max(duration, curve.x.back());
    const std::vector<LegendEntry> legend = legend_of(x);
    PanelPage page({.panel_height = 200, .title = title, .panels = 2, .legends = {names_of(legend)}}, style);
    for (const bool is_x : {true, false}) {
        const std::vector<PictureCurve>& curves = is_x ? x : y;
        const Axes axes = page.axes(is_x ? 0 : 1, Range{0, duration}, range_of(curves));
        axes.draw(page.canvas, is_x ? "" : "time (s)", is_x ? "x (m)" : "y (m)", true);
        draw_curves(page.canvas, axes, curves, 0);
    }
    page.draw_legend(0, legend);
    return std::move(page.canvas);
}

Canvas period_picture(const std::vector<PictureCurve>& curves, const std::string& title,
                      const std::string& y_title, const PageStyle& style) {
    double longest = 0;
    for (const PictureCurve& curve : curves) longest = std::max(longest, curve.x.back());
    const std::vector<LegendEntry> legend = legend_of(curves);
    PanelPage page({.panel_height = 250, .title = title, .legends = {names_of(legend)}}, style);
    const Axes axes = page.axes(0, Range{0, longest}, Range{0, axis_end(curves)});
    axes.draw(page.canvas, "period (s)", y_title, true);
    draw_curves(page.canvas, axes, curves, 0);
    page.draw_legend(0, legend);
    return std::move(page.canvas);
}

}  // namespace rockslope
