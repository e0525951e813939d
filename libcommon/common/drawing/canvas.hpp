#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/drawing/colour.hpp"
#include "common/drawing/page_style.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope {

enum class PictureFormat { svg, png, pdf };

/// The format of a file name's extension, in any letter case. Nothing for an unknown extension.
std::optional<PictureFormat> picture_format(const std::filesystem::path& path);

/// How a line is drawn. Width and dashes in units of the page.
struct Stroke {
    Colour colour = black;
    double width = 0.8;
    std::vector<double> dashes = {};
};

enum class Anchor { start, middle, end };

/// Style of a line of text. Size in units of the page. `anchor` and `vertical` say which part of the text
/// lies at the given point: horizontally start = left, vertically start = baseline and end = top.
struct TextStyle {
    double size = 9;
    Colour colour = black;
    Anchor anchor = Anchor::start;
    Anchor vertical = Anchor::start;
    bool bold = false;
    double angle = 0;                           ///< rad, counter-clockwise
    std::optional<Colour> halo = std::nullopt;  ///< drawn round the letters so that they stand out
};

/// The pixels of a page: rows from the top, each pixel as the bytes blue, green, red and one unused.
struct Pixels {
    int width = 0, height = 0;
    std::string bytes;
};

/// A page in units, of 1 pt (1/72 inch) unless its style says otherwise, origin at the upper left, y
/// downwards. It records drawing commands and writes them as SVG, PDF, or PNG with two pixels per point. The
/// bytes depend only on the commands, not on the time. All lengths below are in units.
class Canvas {
  public:
    /// A white page. @param width, height units, positive. @param style its font and its unit.
    Canvas(double width, double height, const PageStyle& style = {});
    ~Canvas();
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;

    /// Width of the page, pt.
    double width() const;

    /// Fills the rings by the even-odd rule, so that inner rings are holes, and strokes them.
    void polygon(std::span<const Ring> rings, const std::optional<Colour>& fill,
                 const std::optional<Stroke>& stroke);
    /// Parallel lines inside the rings. @param spacing units; @param angle rad, counter-clockwise.
    void hatch(std::span<const Ring> rings, const Stroke& stroke, double spacing, double angle);
    /// An open chain of lines.
    void polyline(std::span<const Point> points, const Stroke& stroke);
    /// A circle, filled and outlined if asked.
    void circle(const Point& centre, double radius, const std::optional<Colour>& fill,
                const std::optional<Stroke>& stroke);
    /// One line of text at a place, anchored as the style says.
    void text(const Point& place, const std::string& line, const TextStyle& style = {});
    /// Width of a line of text.
    double text_width(const std::string& line, const TextStyle& style = {}) const;

    /// Clips all drawing to the box until the matching unclip().
    void clip(const Point& upper_left, const Point& lower_right);
    /// Ends the last clip().
    void unclip();

    /// The page with `per_point` pixels for each point; the last column and row are white where the size is
    /// not whole. Width and height are even, as films need them.
    Pixels pixels(double per_point) const;
    /// The bytes of the picture. Text is text in SVG and PDF. @throws std::runtime_error when Cairo fails.
    std::string bytes(PictureFormat format) const;
    /// Writes the file atomically, in the format of its extension. @throws InputError for an unknown
    /// extension, OutputError when the file cannot be written.
    void write(const std::filesystem::path& path) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace rockslope
