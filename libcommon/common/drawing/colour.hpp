#pragma once

#include <cstddef>

namespace rockslope {

/// Red, green, blue and opacity, each in [0, 1].
struct Colour {
    double red = 0, green = 0, blue = 0, opacity = 1;
    friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr Colour black{0.10, 0.10, 0.12};
inline constexpr Colour grey{0.45, 0.45, 0.48};
inline constexpr Colour pale_grey{0.87, 0.87, 0.88};
inline constexpr Colour white{1, 1, 1};

/// A line colour. The first eight are distinct also for the colour-blind (Okabe and Ito 2008), then they
/// repeat.
Colour line_colour(std::size_t number);

/// A pale fill colour for rock. Repeats after eight.
Colour rock_colour(std::size_t number);

/// A rock colour made lighter or darker by one of `shade_count` steps. Neighbours then differ in shade, and
/// the hue shows the material.
inline constexpr std::size_t shade_count = 5;
Colour shaded(const Colour& colour, std::size_t shade);

/// Linear interpolation between two colours: (1 - weight) first + weight second.
Colour blend(const Colour& first, const Colour& second, double weight);

/// A sequential scale from pale to dark for values in [0, 1], clamped.
Colour scale_colour(double value);

/// A diverging scale for values in [-1, 1], clamped: blue below zero, pale at zero, red above.
Colour diverging_colour(double value);

}  // namespace rockslope
