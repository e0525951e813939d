#pragma once

#include <optional>
#include <string>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// How pictures look.
struct PictureStyle {
    Lettering lettering;
    std::optional<double> width;  ///< of the page, pt; nothing: as wide as the drawing needs
};

/// Size of most text, pt.
inline constexpr double usual_font_size = 9;

/// A length of a page, such as "85mm", "3.3in", "12cm" or "240pt", in pt. @throws InputError.
double page_length(const std::string& text);

}  // namespace rockslope
