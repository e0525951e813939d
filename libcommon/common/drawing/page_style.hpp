#pragma once

#include <optional>
#include <string>

namespace rockslope {

/// Size of most letters, units of a drawing; a unit is 1 pt unless the style says otherwise.
inline constexpr double usual_font_size = 9;

/// How a picture fits the document that it goes into. A drawing is laid out in units in which most letters
/// have the usual size: larger letters leave less room on the same page.
struct PageStyle {
    std::string family = "DejaVu Sans";          ///< font of all text
    double unit = 1;                             ///< of the drawing, pt; positive
    std::optional<double> width = std::nullopt;  ///< of the page, pt; nothing: the usual one of the picture

    /// Width of the page, units. @param usual width of a page without one of its own, pt.
    double width_in_units(double usual) const { return width.value_or(usual) / unit; }
};

/// What a command line says of the looks of pictures; each part may be missing.
struct PageRequest {
    std::optional<std::string> width = std::nullopt;  ///< a length such as "85mm", "3.3in", "12cm" or "240pt"
    std::optional<std::string> font = std::nullopt;
    std::optional<double> font_size = std::nullopt;  ///< of most letters, pt
};

/// The style that is asked for. @param program name that an error begins with. @throws InputError for a width
/// with less room than some thirty letters, for letters above 72 pt, and for a font that is not installed,
/// with the font that would take its place.
PageStyle page_style(const PageRequest& request, const std::string& program);

}  // namespace rockslope
