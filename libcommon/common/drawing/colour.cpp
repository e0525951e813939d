#include "common/drawing/colour.hpp"

#include <algorithm>
#include <array>

namespace rockslope {

namespace {

constexpr Colour rgb(int value) {
    return {((value >> 16) & 255) / 255.0, ((value >> 8) & 255) / 255.0, (value & 255) / 255.0};
}

constexpr std::array line_colours = {rgb(0x0072b2), rgb(0xd55e00), rgb(0x009e73), rgb(0xcc79a7),
                                     rgb(0xb8860b), rgb(0x56b4e9), rgb(0x7b3294), rgb(0x4d4d4d)};
constexpr std::array rock_colours = {rgb(0xe3d5bd), rgb(0xc3ced2), rgb(0xd3dcc0), rgb(0xe0c4ba),
                                     rgb(0xcdc6da), rgb(0xead9a6), rgb(0xbcd5cd), rgb(0xd9cfca)};
constexpr std::array scale_colours = {rgb(0xfdf3dc), rgb(0xf7cf8f), rgb(0xe9925a), rgb(0xc8503f),
                                      rgb(0x7f1d3f)};

// Distinct also for the colour-blind.
constexpr std::array diverging_colours = {rgb(0x2166ac), rgb(0x67a9cf), rgb(0xd1e5f0), rgb(0xf7f7f7),
                                          rgb(0xfddbc7), rgb(0xef8a62), rgb(0xb2182b)};

/// The colour at a position in [0, 1], clamped, between equally spaced colours.
template <std::size_t Count>
Colour colour_along(const std::array<Colour, Count>& colours, double value) {
    const double position = std::clamp(value, 0.0, 1.0) * (Count - 1);
    const auto step = std::min(static_cast<std::size_t>(position), Count - 2);
    return blend(colours[step], colours[step + 1], position - static_cast<double>(step));
}

}  // namespace

Colour line_colour(std::size_t number) {
    return line_colours[number % line_colours.size()];
}

Colour rock_colour(std::size_t number) {
    return rock_colours[number % rock_colours.size()];
}

Colour blend(const Colour& first, const Colour& second, double weight) {
    const auto mix = [weight](double a, double b) { return a + weight * (b - a); };
    return {mix(first.red, second.red), mix(first.green, second.green), mix(first.blue, second.blue),
            mix(first.opacity, second.opacity)};
}

Colour shaded(const Colour& colour, std::size_t shade) {
    constexpr std::array<double, shade_count> steps = {0.0, 0.42, -0.10, 0.22, -0.05};
    const double step = steps[shade % shade_count];
    return step >= 0 ? blend(colour, white, step) : blend(colour, black, -step);
}

Colour scale_colour(double value) {
    return colour_along(scale_colours, value);
}

Colour diverging_colour(double value) {
    return colour_along(diverging_colours, (value + 1) / 2);
}

}  // namespace rockslope
