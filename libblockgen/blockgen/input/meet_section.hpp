#pragma once

#include <optional>
#include <span>

#include "blockgen/input/section_line.hpp"
#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// The plane of a joint. rad, below the horizontal and clockwise from north
struct JointPlane {
    double dip = 0, dip_direction = 0;
};

/// How a mapped trace meets the section line.
enum class Meeting {
    crosses,      ///< the trace itself crosses it
    extended,     ///< its extension along strike does
    too_far,      ///< the extension would be longer than it may be
    beyond_ends,  ///< before the start of the section line or after its end
    parallel      ///< the plane is parallel to the section, or the extension to its line
};

/// Where the outcrop of a joint meets the section line.
struct Outcrop {
    Meeting how = Meeting::parallel;
    double x = 0;                     ///< in the section; where it is met
    std::optional<double> elevation;  ///< of the trace there, or of the end that is extended; if it has any
    double distance = 0;              ///< length of the extension, m
    bool crosses_again = false;       ///< whether the trace crosses the section line more than once
};

/// Where the trace of a joint plane on the map meets the section line: its first crossing along the section,
/// or the crossing of the line of strike through the nearer of its ends, at the distance `reach`, m, or
/// less. @param elevations of the points, or none.
Outcrop meet_section(const SectionLine& section, std::span<const Point> trace,
                     std::span<const double> elevations, const JointPlane& plane, double reach);

/// The angle of a plane's trace in a section of an azimuth, rad from the x axis, in (-pi/2, pi/2]:
/// tan angle = -tan dip cos(dip_direction - azimuth), the apparent dip, negative where the plane dips in the
/// direction of the x axis.
double apparent_angle(const JointPlane& plane, double azimuth);

}  // namespace rockslope::blockgen
