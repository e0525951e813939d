#include "blockgen/picture/density_contours.hpp"

#include "blockgen/picture/contour_lines.hpp"
#include "blockgen/picture/equal_area.hpp"
#include "common/drawing/axes.hpp"

namespace rockslope::blockgen {

namespace {

/// Fine enough for the narrowest kernel, whose standard deviation along the radius at the rim is 0.022.
constexpr DiscGrid net_grid{100, 240};

std::vector<double> values_on_net(const AxisDensity& density) {
    std::vector<double> values(net_grid.spokes, density.at({0, 0, 1}));
    for (std::size_t ring = 1; ring <= net_grid.rings; ++ring)
        for (std::size_t spoke = 0; spoke < net_grid.spokes; ++spoke)
            values.push_back(density.at(direction_at(net_grid.node(ring, spoke))));
    return values;
}

}  // namespace

std::vector<DensityContour> density_contours(const AxisDensity& density) {
    constexpr int most_levels = 8;
    constexpr double significant_deviations = 2.5;
    const double lowest = 1 + significant_deviations * density.uniform_deviation();
    std::vector<DensityContour> contours;
    const std::vector<double> values = values_on_net(density);
    for (const double level : round_ticks({0, density.peak().density}, most_levels))
        if (level > lowest) contours.push_back({level, contour_lines(net_grid, values, level)});
    return contours;
}

}  // namespace rockslope::blockgen
