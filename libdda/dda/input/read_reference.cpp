#include "dda/input/read_reference.hpp"

#include <algorithm>

#include "common/base/text.hpp"
#include "dda/monitor/point_motion.hpp"

namespace rockslope::dda {

std::string read_reference(const ConfigTable& table, const Model& model) {
    const std::vector<TrackedPoint> points = tracked_points(model);
    const auto base = std::find_if(points.begin(), points.end(),
                                   [](const TrackedPoint& point) { return point.block.exists(); });
    std::string name = table.string("relative_to", base == points.end() ? "" : base->name);
    if (name.empty() || find_point(points, name)) return name;
    std::vector<std::string> names;
    for (const TrackedPoint& point : points) names.push_back(point.name);
    const auto nearest = nearest_word(name, names);
    table.fail("relative_to", "there is no measured point and no prescribed block '" + name + "'",
               nearest ? "perhaps '" + *nearest + "'" : "a name in the block file, or \"\"");
}

}  // namespace rockslope::dda
