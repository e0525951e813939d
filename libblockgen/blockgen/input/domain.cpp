#include "blockgen/input/domain.hpp"

#include <algorithm>

namespace rockslope::blockgen {

Bounds domain_bounds(const SlopeModel& model) {
    Ring corners = model.outline;
    for (const Ring& part : model.further_outlines) corners.insert(corners.end(), part.begin(), part.end());
    return Bounds::of(corners);
}

bool is_in_outlines(const SlopeModel& model, const Point& p) {
    const auto contains_p = [&p](const Ring& part) { return side_of_ring(part, p) >= 0; };
    return contains_p(model.outline) ||
           std::any_of(model.further_outlines.begin(), model.further_outlines.end(), contains_p);
}

std::optional<double> ground_elevation(const SlopeModel& model, double x) {
    std::optional<double> highest;
    const auto take = [&](double y) { highest = highest ? std::max(*highest, y) : y; };
    const auto take_ring = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
            if (a.x == x) take(a.y);
            if ((a.x < x && x < b.x) || (b.x < x && x < a.x))
                take(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)));
        }
    };
    take_ring(model.outline);
    for (const Ring& part : model.further_outlines) take_ring(part);
    return highest;
}

std::string system_urn(const SlopeModel& model) {
    if (model.section && model.section->on_map) return {};
    return (model.project.exists() ? model.project : model.system).urn();
}

}  // namespace rockslope::blockgen
