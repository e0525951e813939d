#include "common/drawing/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "common/base/text.hpp"

namespace rockslope {

namespace {

constexpr double pixels_per_point = 2;

struct SurfaceDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextDeleter {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void set_colour(cairo_t* context, const Colour& colour) {
    cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.opacity);
}

void set_stroke(cairo_t* context, const Stroke& stroke) {
    set_colour(context, stroke.colour);
    cairo_set_line_width(context, stroke.width);
    cairo_set_dash(context, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0);
}

void trace(cairo_t* context, std::span<const Point> points) {
    cairo_new_sub_path(context);
    for (const Point& p : points) cairo_line_to(context, p.x, p.y);
}

void trace_rings(cairo_t* context, std::span<const Ring> rings) {
    cairo_new_path(context);
    for (const Ring& ring : rings) {
        trace(context, ring);
        cairo_close_path(context);
    }
}

void finish_path(cairo_t* context, const std::optional<Colour>& fill, const std::optional<Stroke>& stroke) {
    if (fill) {
        set_colour(context, *fill);
        cairo_fill_preserve(context);
    }
    if (stroke) {
        set_stroke(context, *stroke);
        cairo_stroke_preserve(context);
    }
    cairo_new_path(context);
}

void set_font(cairo_t* context, const std::string& family, const TextStyle& style) {
    cairo_select_font_face(context, family.c_str(), CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size);
}

void draw_hatch(cairo_t* context, std::span<const Ring> rings, const Stroke& stroke, double spacing,
                double angle) {
    const double ux = std::cos(angle), uy = -std::sin(angle);
    double low = std::numeric_limits<double>::infinity(), high = -low, first = low, last = -low;
    for (const Ring& ring : rings)
        for (const Point& p : ring) {
            low = std::min(low, p.y * ux - p.x * uy);
            high = std::max(high, p.y * ux - p.x * uy);
            first = std::min(first, p.x * ux + p.y * uy);
            last = std::max(last, p.x * ux + p.y * uy);
        }
    if (!(low < high)) return;
    cairo_save(context);
    trace_rings(context, rings);
    cairo_clip(context);
    const auto last_line = static_cast<std::int64_t>(std::floor(high / spacing));
    for (auto k = static_cast<std::int64_t>(std::ceil(low / spacing)); k <= last_line; ++k) {
        const double offset = static_cast<double>(k) * spacing;
        cairo_move_to(context, first * ux - offset * uy, first * uy + offset * ux);
        cairo_line_to(context, last * ux - offset * uy, last * uy + offset * ux);
    }
    set_stroke(context, stroke);
    cairo_stroke(context);
    cairo_restore(context);
}

double fraction_of(Anchor anchor) {
    return anchor == Anchor::start ? 0.0 : anchor == Anchor::middle ? 0.5 : 1.0;
}

/// A line of text at its place on the page.
struct TextLine {
    Point place;
    std::string line, family;
    TextStyle style;
    double width = 0;  ///< pt

    /// Distance of the baseline below the place, pt.
    double drop() const {
        constexpr double cap_height = 0.73;
        return fraction_of(style.vertical) * cap_height * style.size;
    }
};

void draw_text(cairo_t* context, const TextLine& text) {
    const TextStyle& style = text.style;
    const double dx = -fraction_of(style.anchor) * text.width;
    set_font(context, text.family, style);
    cairo_save(context);
    cairo_translate(context, text.place.x, text.place.y);
    cairo_rotate(context, -style.angle);
    cairo_move_to(context, dx, text.drop());
    if (style.halo) {
        cairo_text_path(context, text.line.c_str());
        set_stroke(context, {*style.halo, 0.3 * style.size});
        cairo_stroke(context);
        cairo_move_to(context, dx, text.drop());
    }
    set_colour(context, style.colour);
    cairo_show_text(context, text.line.c_str());
    cairo_new_path(context);
    cairo_restore(context);
}

std::string svg_colour(const Colour& colour) {
    const auto byte = [](double value) { return static_cast<int>(std::lround(255 * value)); };
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(colour.red), byte(colour.green),
                  byte(colour.blue));
    return text;
}

/// The text element of an SVG. Cairo would draw the letters as outlines, which no editor can change.
std::string svg_text(const TextLine& text) {
    static constexpr const char* anchors[] = {"start", "middle", "end"};
    constexpr double degrees = 180 / M_PI;
    const TextStyle& style = text.style;
    char place[256];
    std::snprintf(place, sizeof place,
                  "<text transform=\"translate(%.2f %.2f) rotate(%.2f)\" y=\"%.2f\" font-size=\"%.2f\" "
                  "text-anchor=\"%s\"",
                  text.place.x, text.place.y, -style.angle * degrees + 0.0, text.drop(), style.size,
                  anchors[static_cast<int>(style.anchor)]);
    std::string element = place;
    element += " font-family=\"" + xml_escaped(text.family) + ", sans-serif\" fill=\"" +
               svg_colour(style.colour) + "\"";
    if (style.bold) element += " font-weight=\"bold\"";
    if (style.halo) {
        std::snprintf(place, sizeof place, "%.2f", 0.3 * style.size);
        element += " paint-order=\"stroke\" stroke-linejoin=\"round\" stroke=\"" + svg_colour(*style.halo) +
                   "\" stroke-width=\"" + place + "\"";
    }
    return element + ">" + xml_escaped(text.line) + "</text>\n";
}

/// Removes the surface numbers from the identifiers of an SVG. Cairo counts the surfaces of a process, and
/// the same picture must have the same bytes.
std::string without_surface_numbers(std::string svg) {
    constexpr std::string_view word = "surface";
    for (std::size_t at = svg.find(word); at != std::string::npos; at = svg.find(word, at)) {
        at += word.size();
        std::size_t end = at;
        while (end < svg.size() && svg[end] >= '0' && svg[end] <= '9') ++end;
        svg.erase(at, end - at);
    }
    return svg;
}

/// An SVG with its texts before the end of the root element. @param unit pt for one unit of the texts.
std::string with_texts(std::string svg, const std::vector<TextLine>& texts, double unit) {
    std::string elements;
    for (TextLine text : texts) {
        text.place = {unit * text.place.x, unit * text.place.y};
        text.style.size *= unit;
        elements += svg_text(text);
    }
    const std::size_t end = svg.rfind("</svg>");
    return svg.insert(end == std::string::npos ? svg.size() : end, elements);
}

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("drawing failed: ") + cairo_status_to_string(status));
}

}  // namespace

struct Canvas::Impl {
    using Command = std::function<void(cairo_t*)>;

    double width, height;  ///< units
    PageStyle style;
    std::vector<Command> commands;
    std::vector<TextLine> texts;  ///< drawn last, over everything else
    Surface sheet{cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1)};
    Context ruler{cairo_create(sheet.get())};  ///< measures text

    Impl(double page_width, double page_height, const PageStyle& page_style)
        : width(page_width), height(page_height), style(page_style) {
        // Widths of letters on any page, not rounded to the pixels of this sheet.
        cairo_font_options_t* options = cairo_font_options_create();
        cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
        cairo_set_font_options(ruler.get(), options);
        cairo_font_options_destroy(options);
    }

    double points(double length) const { return length * style.unit; }

    // Cairo's recording surface is not used, because SVG output never frees such a source (Cairo 1.16).
    void replay(cairo_surface_t* target, double scale, bool with_text) const {
        const Context to(cairo_create(target));
        cairo_scale(to.get(), scale * style.unit, scale * style.unit);
        set_colour(to.get(), white);
        cairo_paint(to.get());
        cairo_set_line_join(to.get(), CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(to.get(), CAIRO_LINE_CAP_ROUND);
        cairo_set_fill_rule(to.get(), CAIRO_FILL_RULE_EVEN_ODD);
        for (const Command& command : commands) command(to.get());
        if (with_text)
            for (const TextLine& text : texts) draw_text(to.get(), text);
        check(cairo_status(to.get()));
    }
};

Canvas::Canvas(double width, double height, const PageStyle& style)
    : impl_(std::make_unique<Impl>(width, height, style)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

double Canvas::width() const {
    return impl_->points(impl_->width);
}

void Canvas::polygon(std::span<const Ring> rings, const std::optional<Colour>& fill,
                     const std::optional<Stroke>& stroke) {
    impl_->commands.emplace_back(
        [shape = std::vector<Ring>(rings.begin(), rings.end()), fill, stroke](cairo_t* to) {
            trace_rings(to, shape);
            finish_path(to, fill, stroke);
        });
}

void Canvas::hatch(std::span<const Ring> rings, const Stroke& stroke, double spacing, double angle) {
    impl_->commands.emplace_back([shape = std::vector<Ring>(rings.begin(), rings.end()), stroke, spacing,
                                  angle](cairo_t* to) { draw_hatch(to, shape, stroke, spacing, angle); });
}

void Canvas::polyline(std::span<const Point> points, const Stroke& stroke) {
    impl_->commands.emplace_back(
        [line = std::vector<Point>(points.begin(), points.end()), stroke](cairo_t* to) {
            cairo_new_path(to);
            trace(to, line);
            finish_path(to, std::nullopt, stroke);
        });
}

void Canvas::circle(const Point& centre, double radius, const std::optional<Colour>& fill,
                    const std::optional<Stroke>& stroke) {
    impl_->commands.emplace_back([=](cairo_t* to) {
        cairo_new_path(to);
        cairo_arc(to, centre.x, centre.y, radius, 0, 2 * M_PI);
        finish_path(to, fill, stroke);
    });
}

double Canvas::text_width(const std::string& line, const TextStyle& style) const {
    set_font(impl_->ruler.get(), impl_->style.family, style);
    cairo_text_extents_t extents;
    cairo_text_extents(impl_->ruler.get(), line.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::text(const Point& place, const std::string& line, const TextStyle& style) {
    impl_->texts.push_back({place, line, impl_->style.family, style, text_width(line, style)});
}

void Canvas::clip(const Point& upper_left, const Point& lower_right) {
    impl_->commands.emplace_back([=](cairo_t* to) {
        cairo_save(to);
        cairo_rectangle(to, upper_left.x, upper_left.y, lower_right.x - upper_left.x,
                        lower_right.y - upper_left.y);
        cairo_clip(to);
    });
}

void Canvas::unclip() {
    impl_->commands.emplace_back(cairo_restore);
}

std::string Canvas::bytes(PictureFormat format) const {
    std::string out;
    const Impl& page = *impl_;
    Surface surface;
    if (format == PictureFormat::png) {
        surface.reset(cairo_image_surface_create(
            CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(page.points(page.width) * pixels_per_point)),
            static_cast<int>(std::ceil(page.points(page.height) * pixels_per_point))));
        page.replay(surface.get(), pixels_per_point, true);
        check(cairo_surface_write_to_png_stream(surface.get(), append, &out));
        return out;
    }
    if (format == PictureFormat::svg) {
        surface.reset(cairo_svg_surface_create_for_stream(append, &out, page.points(page.width),
                                                          page.points(page.height)));
    } else {
        surface.reset(cairo_pdf_surface_create_for_stream(append, &out, page.points(page.width),
                                                          page.points(page.height)));
        // The default is the current time.
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    }
    page.replay(surface.get(), 1, format == PictureFormat::pdf);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return format == PictureFormat::svg
               ? with_texts(without_surface_numbers(std::move(out)), page.texts, page.style.unit)
               : out;
}

Pixels Canvas::pixels(double per_point) const {
    const auto even = [&](double length) {
        return 2 * static_cast<int>(std::ceil(impl_->points(length) * per_point / 2));
    };
    Pixels image{even(impl_->width), even(impl_->height), {}};
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
    impl_->replay(surface.get(), per_point, true);
    cairo_surface_flush(surface.get());
    const auto* data = reinterpret_cast<const char*>(cairo_image_surface_get_data(surface.get()));
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y)
        image.bytes.append(data + stride * static_cast<std::size_t>(y), row);
    return image;
}

std::optional<PictureFormat> picture_format(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".svg") return PictureFormat::svg;
    if (extension == ".png") return PictureFormat::png;
    if (extension == ".pdf") return PictureFormat::pdf;
    return std::nullopt;
}

void Canvas::write(const std::filesystem::path& path) const {
    const auto format = picture_format(path);
    if (!format)
        throw InputError({path.string()}, "'" + path.extension().string() + "' is no known picture format",
                         ".svg, .png or .pdf");
    write_file_atomically(path, bytes(*format));
}

}  // namespace rockslope
