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

VerticalSections outline_sections(const SlopeModel& model) {
    std::vector<Ring> outlines = {model.outline};
    outlines.insert(outlines.end(), model.further_outlines.begin(), model.further_outlines.end());
    return VerticalSections(outlines);
}

std::string system_urn(const SlopeModel& model) {
    if (model.section && model.section->on_map) return {};
    return (model.project.exists() ? model.project : model.system).urn();
}

}  // namespace rockslope::blockgen
