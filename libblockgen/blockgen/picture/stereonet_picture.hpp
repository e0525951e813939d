#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope::blockgen {

/// A plane of a stereonet: dip and dip direction clockwise from north, rad.
struct StereonetPlane {
    double dip = 0, dip_direction = 0;
};

/// The planes of a set of joints.
struct StereonetSet {
    std::string name;
    std::vector<StereonetPlane> planes;
    StereonetPlane mean;
    std::optional<double> fisher_k;  ///< estimated; nothing when the planes are all the same
};

/// Planes in space, and the vertical section that cuts them.
struct Stereonet {
    std::vector<StereonetSet> sets;
    double section_azimuth = 0;               ///< rad, of its x axis, clockwise from north
    std::vector<std::string> without_planes;  ///< names of joints that are no sets of planes, in the legend
};

/// Draws the poles of planes on the lower hemisphere in equal-area projection, with the mean plane of each
/// set as its pole and its great circle, and the section as a line. The legend gives dip and dip direction of
/// the mean, Fisher's K and the number of planes. Of poles that would cover each other one is drawn. Contours
/// of the density of all poles (AxisDensity) run from pale to dark; the legend has their values.
Canvas draw_stereonet(const Stereonet& net, const PageStyle& style = {});

}  // namespace rockslope::blockgen
