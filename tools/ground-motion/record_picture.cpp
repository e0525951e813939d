#include "record_picture.hpp"

#include <algorithm>
#include <vector>

#include "blockgen/picture/axes.hpp"
#include "dda/record/response_spectrum.hpp"

namespace {

using blockgen::Axes;
using blockgen::Canvas;
using blockgen::Point;
using blockgen::Range;

constexpr double standard_gravity = 9.80665;  // m/s2

struct Curve {
    std::vector<double> x;
    std::vector<double> y;
};

/// The curve's largest magnitude with some air above it.
double reach(const Curve& curve) {
    return 1.1 * std::max(dda::largest_magnitude(curve.y), 1e-9);
}

void draw_curve(Canvas& canvas, const Axes& axes, const Curve& curve, std::size_t number) {
    std::vector<Point> line;
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        line.push_back(axes.to_page(Point{curve.x[k], curve.y[k]}));
    }
    canvas.polyline(line, {blockgen::line_colour(number), 0.7});
}

Curve scaled(const std::vector<double>& times, const std::vector<double>& values, double factor) {
    Curve curve{times, values};
    for (double& value : curve.y) {
        value *= factor;
    }
    return curve;
}

Curve spectrum_curve(const dda::Accelerogram& record) {
    Curve curve;
    for (int k = 1; k <= 200; ++k) curve.x.push_back(0.02 * k);
    for (const dda::SpectralOrdinate& ordinate : dda::response_spectrum(record, curve.x, 0.05)) {
        curve.y.push_back(ordinate.absolute_acceleration / standard_gravity);
    }
    return curve;
}

}  // namespace

Canvas record_picture(const dda::Accelerogram& record, const std::string& title) {
    const dda::GroundMotion motion = dda::integrate(record);
    std::vector<double> times;
    for (std::size_t k = 0; k < record.values.size(); ++k) {
        times.push_back(static_cast<double>(k) * record.step);
    }
    const std::vector<Curve> curves = {scaled(times, record.values, 1 / standard_gravity),
                                       scaled(times, motion.velocity, 1),
                                       scaled(times, motion.displacement, 1)};
    const std::vector<std::string> titles = {"acceleration (g)", "velocity (m/s)", "displacement (m)"};

    Canvas canvas(760, 640);
    canvas.text({72, 22}, title, {.size = 11, .bold = true});
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const double top = 38 + 195 * static_cast<double>(k);
        const Axes axes({72, top}, {445, top + 165}, Range{0, record.duration()},
                        Range{-reach(curves[k]), reach(curves[k])});
        axes.draw(canvas, k + 1 == curves.size() ? "time (s)" : "", titles[k], true);
        draw_curve(canvas, axes, curves[k], k);
    }
    const Curve spectrum = spectrum_curve(record);
    const Axes axes({518, 38}, {740, 593}, Range{0, 4}, Range{0, reach(spectrum)});
    axes.draw(canvas, "period (s)", "absolute acceleration, 5 % damping (g)", true);
    draw_curve(canvas, axes, spectrum, 3);
    return canvas;
}
