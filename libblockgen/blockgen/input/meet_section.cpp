#include "blockgen/input/meet_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blockgen/input/orientation.hpp"

namespace rockslope::blockgen {

namespace {

/// Below this chance to be met a plane counts as parallel to the section, and below this sine of the angle
/// between them a line as parallel to the section line: azimuths are not known to a millionth.
constexpr double parallel_limit = 1e-6;

/// Rounding of coordinates on the map, m: what should lie on the section line or at its end may miss it by so
/// much.
constexpr double map_rounding = 1e-6;

bool is_on(const SectionLine& section, double x) {
    return x >= -map_rounding && x <= section.length() + map_rounding;
}

Outcrop crossing_of(const SectionLine& section, std::span<const Point> trace,
                    std::span<const double> elevations) {
    Outcrop found;
    int crossings = 0;
    bool is_beyond = false;
    const auto add = [&](double x, std::size_t k, double part) {
        if (!is_on(section, x)) {
            is_beyond = true;
            return;
        }
        if (++crossings > 1 && x >= found.x) return;
        found.x = x;
        if (!elevations.empty())
            found.elevation =
                part == 0 ? elevations[k] : elevations[k] + part * (elevations[k + 1] - elevations[k]);
    };
    for (std::size_t k = 0; k < trace.size(); ++k) {
        const double here = section.across(trace[k]), x = section.along(trace[k]);
        if (here == 0) add(x, k, 0);
        if (k + 1 == trace.size()) break;
        const double next = section.across(trace[k + 1]);
        if (!((here < 0 && next > 0) || (here > 0 && next < 0))) continue;
        const double part = here / (here - next);
        add(x + part * (section.along(trace[k + 1]) - x), k, part);
    }
    found.how = crossings > 0 ? Meeting::crosses : is_beyond ? Meeting::beyond_ends : Meeting::parallel;
    found.crosses_again = crossings > 1;
    return found;
}

/// Where the line of strike through the nearer end of a trace meets the section line.
Outcrop extension_of(const SectionLine& section, std::span<const Point> trace,
                     std::span<const double> elevations, double strike, double reach) {
    // Along strike, m per m: along the section line and to its left.
    const double turn = strike - section.azimuth();
    const double along = std::cos(turn), across = -std::sin(turn);
    Outcrop found;
    if (std::abs(across) < parallel_limit) return found;
    bool is_first = true;
    for (const std::size_t end : {std::size_t{0}, trace.size() - 1}) {
        const double step = -section.across(trace[end]) / across;
        if (!is_first && std::abs(step) >= found.distance) continue;
        is_first = false;
        found.distance = std::abs(step);
        found.x = section.along(trace[end]) + step * along;
        if (!elevations.empty()) found.elevation = elevations[end];
    }
    found.how = found.distance > reach + map_rounding ? Meeting::too_far
                : is_on(section, found.x)             ? Meeting::extended
                                                      : Meeting::beyond_ends;
    return found;
}

}  // namespace

double apparent_angle(const JointPlane& plane, double azimuth) {
    return trace_angle(pole_of(plane.dip, plane.dip_direction, azimuth));
}

Outcrop meet_section(const SectionLine& section, std::span<const Point> trace,
                     std::span<const double> elevations, const JointPlane& plane, double reach) {
    if (section_chance(pole_of(plane.dip, plane.dip_direction, section.azimuth())) < parallel_limit)
        return {};
    Outcrop outcrop = crossing_of(section, trace, elevations);
    if (outcrop.how == Meeting::parallel)
        outcrop = extension_of(section, trace, elevations, plane.dip_direction - std::numbers::pi / 2, reach);
    if (is_on(section, outcrop.x)) outcrop.x = std::clamp(outcrop.x, 0.0, section.length());
    return outcrop;
}

}  // namespace rockslope::blockgen
