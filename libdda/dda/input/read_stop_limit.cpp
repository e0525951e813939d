#include <algorithm>

#include "common/base/text.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_reference.hpp"
#include "dda/input/read_stages.hpp"
#include "dda/monitor/point_motion.hpp"

namespace rockslope::dda {

namespace {

/// Fails with the known name that is nearest to the one given.
[[noreturn]] void fail_for_name(const ConfigTable& table, const char* key, const std::string& what,
                                const std::string& name, const std::vector<std::string>& names) {
    const auto nearest = nearest_word(name, names);
    table.fail(key, "there is no " + what + " '" + name + "'",
               nearest ? "perhaps '" + *nearest + "'" : "the name of a " + what);
}

void read_watched_point(const ConfigTable& table, const Model& model, StopLimit& stop) {
    stop.watched = table.string("point");
    std::vector<std::string> names;
    for (const MeasuredPointSpec& point : model.measured_points) {
        names.push_back(point.name);
        if (point.name == stop.watched && !stop.point.exists()) stop.point = point.point;
    }
    if (!stop.point.exists()) fail_for_name(table, "point", "measured point", stop.watched, names);
}

void read_watched_region(const ConfigTable& table, const Model& model, StopLimit& stop) {
    stop.watched = table.string("region");
    std::vector<std::string> names;
    for (const MeasuredRegion& region : model.measured_regions) {
        names.push_back(region.name);
        if (region.name == stop.watched) stop.blocks = region.blocks;
    }
    if (stop.blocks.empty()) fail_for_name(table, "region", "measured region", stop.watched, names);
}

}  // namespace

std::optional<StopLimit> read_stop_limit(const ConfigTable& stage, const Model& model) {
    const std::optional<ConfigTable> table = stage.optional_table("stop");
    if (!table) return std::nullopt;
    StopLimit stop;
    stop.displacement = positive(*table, "displacement", Dimension::length);
    if (!table->has("point"))
        stop.share = table->checked(
            "share", table->number("share", Dimension::none, 0), [](double v) { return v >= 0 && v < 1; },
            "a share from 0 to below 1");
    if (table->has("point") && table->has("region"))
        table->fail("region", "[" + table->path() + "] has 'point' and 'region'",
                    "one of them, or neither for any free block");
    if (table->has("point")) read_watched_point(*table, model, stop);
    if (table->has("region")) read_watched_region(*table, model, stop);
    const std::vector<TrackedPoint> points = tracked_points(model);
    if (const auto reference = find_point(points, read_reference(*table, model))) {
        stop.reference_point = points[*reference].material_point;
        stop.reference_block = points[*reference].block;
    }
    return stop;
}

}  // namespace rockslope::dda
