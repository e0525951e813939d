#include "record_picture.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "common/drawing/axes.hpp"
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
    canvas.clip(axes.upper_left(), axes.lower_right());
    for (std::size_t number = 0; number < curves.size(); ++number) {
        const PictureCurve& curve = curves[number];
        std::vector<Point> line;
        for (std::size_t k = 0; k < curve.x.size(); ++k)
            line.push_back(axes.to_page(Point{curve.x[k], curve.y[k]}));
        canvas.polyline(line, {line_colour(colour_of(curves, number, panel)), 0.7});
    }
    canvas.unclip();
}

void draw_names(Canvas& canvas, const Point& place, const std::vector<PictureCurve>& curves) {
    std::vector<LegendEntry> entries;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        LegendEntry entry;
        entry.text = curves[k].name;
        entry.stroke = Stroke{line_colour(k), 1.1};
        entry.is_line = true;
        entries.push_back(entry);
    }
    draw_legend(canvas, place, "", entries);
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

}  // namespace

Canvas record_picture(const std::vector<NamedRecord>& records, const std::string& title) {
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
    const double legend = records.size() > 1 ? 16.0 * static_cast<double>(records.size()) + 12 : 0;

    Canvas canvas(760, 640 + legend);
    canvas.text({72, 22}, title, {.size = 11, .bold = true});
    for (std::size_t k = 0; k < histories.size(); ++k) {
        const double top = 38 + 195 * static_cast<double>(k);
        const double end = axis_end(histories[k]);
        const Axes axes({72, top}, {445, top + 165}, Range{0, duration}, Range{-end, end});
        axes.draw(canvas, k + 1 == histories.size() ? "time (s)" : "", titles[k], true);
        draw_curves(canvas, axes, histories[k], k);
    }
    const Axes axes({518, 38}, {740, 593}, Range{0, 4}, Range{0, axis_end(spectra)});
    axes.draw(canvas, "period (s)", "absolute acceleration, 5 % damping (g)", true);
    draw_curves(canvas, axes, spectra, 3);
    if (records.size() > 1) draw_names(canvas, {72, 632}, spectra);
    return canvas;
}

Canvas displacement_picture(const std::vector<PictureCurve>& x, const std::vector<PictureCurve>& y,
                            const std::string& title) {
    double duration = 1e-9;
    for (const PictureCurve& curve : x) duration = std::max(duration, curve.x.back());
    Canvas canvas(640, 510 + 16 * static_cast<double>(x.size()) + 12);
    canvas.text({64, 22}, title, {.size = 11, .bold = true});
    for (const bool is_x : {true, false}) {
        const std::vector<PictureCurve>& curves = is_x ? x : y;
        const double top = is_x ? 34 : 256;
        const Axes axes({64, top}, {620, top + 200}, Range{0, duration}, range_of(curves));
        axes.draw(canvas, is_x ? "" : "time (s)", is_x ? "x (m)" : "y (m)", true);
        draw_curves(canvas, axes, curves, 0);
    }
    draw_names(canvas, {64, 498}, x);
    return canvas;
}

Canvas period_picture(const std::vector<PictureCurve>& curves, const std::string& title,
                      const std::string& y_title) {
    double longest = 0;
    for (const PictureCurve& curve : curves) longest = std::max(longest, curve.x.back());
    Canvas canvas(560, 330 + 16 * static_cast<double>(curves.size()) + 12);
    canvas.text({60, 22}, title, {.size = 11, .bold = true});
    const Axes axes({60, 34}, {540, 284}, Range{0, longest}, Range{0, axis_end(curves)});
    axes.draw(canvas, "period (s)", y_title, true);
    draw_curves(canvas, axes, curves, 0);
    draw_names(canvas, {60, 322}, curves);
    return canvas;
}

}  // namespace rockslope
