#include "report/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace rockslope::verification {

namespace {

constexpr double width = 640, height = 380;  // of the whole drawing, px
constexpr double left = 72, right = 16, top = 54, bottom = 48;
constexpr const char* colours[] = {"#f0a860", "#1f4e9c", "#2a8a4a", "#a03050", "#6a4a9c"};

Picture read_picture(const std::filesystem::path& path) {
    std::ifstream in(path);
    Picture picture;
    picture.stem = path.stem().string();
    picture.id = picture.stem.substr(0, picture.stem.find('-'));
    std::getline(in, picture.title);
    std::getline(in, picture.x_label);
    std::getline(in, picture.y_label);
    std::size_t count = 0;
    while (in >> count) {
        Curve curve;
        std::getline(in >> std::ws, curve.name);
        curve.x.resize(count);
        curve.y.resize(count);
        for (std::size_t k = 0; k < count; ++k) in >> curve.x[k] >> curve.y[k];
        if (!in)
            throw std::runtime_error(path.string() + ": curve '" + curve.name + "' has fewer than " +
                                     std::to_string(count) + " points");
        picture.curves.push_back(std::move(curve));
    }
    if (picture.curves.empty()) throw std::runtime_error(path.string() + ": no curve");
    return picture;
}

/// The range of an axis, widened to multiples of the tick.
struct Axis {
    double low, high, tick;

    Axis(double least, double most) {
        if (most <= least) most = least + 1;
        const double rough = (most - least) / 6;
        const double decade = std::pow(10, std::floor(std::log10(rough)));
        const double ratio = rough / decade;
        tick = decade * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
        low = tick * std::floor(least / tick + 1e-9);
        high = tick * std::ceil(most / tick - 1e-9);
    }
    double fraction(double value) const { return (value - low) / (high - low); }
    int ticks() const { return static_cast<int>(std::lround((high - low) / tick)); }
    double at(int k) const { return low + k * tick; }
};

Axis axis_of(const Picture& picture, std::vector<double> Curve::*values) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const Curve& curve : picture.curves) {
        for (const double v : curve.*values) {
            least = std::min(least, v);
            most = std::max(most, v);
        }
    }
    return {least, most};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::abs(value) < 1e-12 ? 0.0 : value);
    return text;
}
std::string pixel(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string escaped(const std::string& text) {
    std::string made;
    for (const char c : text) {
        if (c == '&')
            made += "&amp;";
        else if (c == '<')
            made += "&lt;";
        else
            made += c;
    }
    return made;
}

struct Frame {
    Axis x, y;
    std::string px(double value) const { return pixel(left + (width - left - right) * x.fraction(value)); }
    std::string py(double value) const {
        return pixel(height - bottom - (height - top - bottom) * y.fraction(value));
    }
};

void text(std::ostream& out, const std::string& x, const std::string& y, const std::string& anchor,
          const std::string& words, const std::string& more = {}) {
    out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\"" << more << ">"
        << escaped(words) << "</text>\n";
}

void draw_axes(std::ostream& out, const Picture& picture, const Frame& frame) {
    for (int k = 0; k <= frame.x.ticks(); ++k) {
        const std::string x = frame.px(frame.x.at(k));
        out << "<path class=\"grid\" d=\"M" << x << ' ' << pixel(top) << 'V' << pixel(height - bottom)
            << "\"/>\n";
        text(out, x, pixel(height - bottom + 16), "middle", number(frame.x.at(k)));
    }
    for (int k = 0; k <= frame.y.ticks(); ++k) {
        const std::string y = frame.py(frame.y.at(k));
        out << "<path class=\"grid\" d=\"M" << pixel(left) << ' ' << y << 'H' << pixel(width - right)
            << "\"/>\n";
        text(out, pixel(left - 6), y, "end", number(frame.y.at(k)), " dy=\"4\"");
    }
    text(out, pixel((left + width - right) / 2), pixel(height - 10), "middle", picture.x_label);
    text(out, "16", pixel((top + height - bottom) / 2), "middle", picture.y_label,
         " transform=\"rotate(-90 16 " + pixel((top + height - bottom) / 2) + ")\"");
    text(out, pixel(left), "20", "start", picture.title, " font-weight=\"bold\"");
}

/// Indices of about 500 evenly spaced points of a curve, as many as there are pixels.
std::vector<std::size_t> thinned(const Curve& curve) {
    const std::size_t stride = std::max<std::size_t>(1, curve.x.size() / 500);
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < curve.x.size(); k += stride) kept.push_back(k);
    if (!curve.x.empty() && kept.back() + 1 != curve.x.size()) kept.push_back(curve.x.size() - 1);
    return kept;
}

void draw_curve(std::ostream& out, const Curve& curve, const Frame& frame, std::size_t index) {
    out << "<polyline fill=\"none\" stroke=\"" << colours[index % std::size(colours)] << "\" stroke-width=\""
        << (index == 0 ? "5" : "1.5") << "\" stroke-linejoin=\"round\" points=\"";
    for (const std::size_t k : thinned(curve))
        out << frame.px(curve.x[k]) << ',' << frame.py(curve.y[k]) << ' ';
    out << "\"/>\n";
}

/// Draws the legend in one line below the title, for letters 6.7 px wide.
void draw_legend(std::ostream& out, const Picture& picture) {
    double x = left;
    const double y = 38;
    for (std::size_t k = 0; k < picture.curves.size(); ++k) {
        const std::string& name = picture.curves[k].name;
        out << "<path d=\"M" << pixel(x) << ' ' << pixel(y) << "h24\" stroke=\""
            << colours[k % std::size(colours)] << "\" stroke-width=\"" << (k == 0 ? "5" : "1.5") << "\"/>\n";
        text(out, pixel(x + 30), pixel(y), "start", name, " dy=\"4\"");
        x += 56 + 6.7 * static_cast<double>(name.size());
    }
}

}  // namespace

std::vector<Picture> read_pictures(const std::string& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".curves") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Picture> pictures;
    for (const auto& path : paths) pictures.push_back(read_picture(path));
    return pictures;
}

std::string draw(const Picture& picture) {
    const Frame frame{axis_of(picture, &Curve::x), axis_of(picture, &Curve::y)};
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
        << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<style>.grid{stroke:#ddd;fill:none} "
           ".key{paint-order:stroke;stroke:#fff;stroke-width:4px}</style>\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    draw_axes(out, picture, frame);
    for (std::size_t k = 0; k < picture.curves.size(); ++k) draw_curve(out, picture.curves[k], frame, k);
    draw_legend(out, picture);
    out << "</svg>\n";
    return out.str();
}

}  // namespace rockslope::verification
