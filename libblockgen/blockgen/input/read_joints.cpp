#include <algorithm>
#include <cmath>

#include "blockgen/base/text.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/read_shapes.hpp"

namespace blockgen {

namespace {

Law law_of(const std::string& word) {
    if (word == "uniform") return Law::uniform;
    if (word == "normal") return Law::normal;
    if (word == "lognormal") return Law::lognormal;
    if (word == "exponential") return Law::exponential;
    return Law::constant;
}

void read_moments(const ConfigTable& table, Dimension dimension, Distribution& d) {
    const auto positive = [](double x) { return x > 0; };
    const bool of_positive_values = d.law == Law::lognormal || d.law == Law::exponential;
    d.mean = table.number("mean", dimension);
    if (of_positive_values) table.checked("mean", d.mean, positive, "a positive mean");
    if (d.law == Law::normal || d.law == Law::lognormal)
        d.sd = table.checked(
            "sd", table.number("sd", dimension), [](double x) { return x >= 0; },
            "a standard deviation of zero or more");
}

/// A plain number, or a table with a law.
Distribution read_distribution(const ConfigTable& parent, std::string_view key, Dimension dimension) {
    if (!parent.is_table(key)) return constant_value(parent.number(key, dimension));
    const ConfigTable table = parent.table(key);
    Distribution d;
    d.law = law_of(table.choice("law", {"constant", "uniform", "normal", "lognormal", "exponential"}));
    if (d.law == Law::constant) {
        d = constant_value(table.has("value") ? table.number("value", dimension)
                                              : table.number("mean", dimension));
        table.finish();
        return d;
    }
    if (d.law != Law::uniform) read_moments(table, dimension, d);
    if (d.law == Law::uniform || table.has("min")) d.min = table.number("min", dimension);
    if (d.law == Law::uniform || table.has("max")) d.max = table.number("max", dimension);
    if (!(d.min < d.max)) table.fail("max", "max is not above min", "max > min");
    if (!d.has_weight())
        table.fail("mean", "the law has no weight between min and max", "bounds near the mean");
    table.finish();
    return d;
}

/// A distribution of lengths no draw of which is negative.
Distribution read_length(const ConfigTable& table, std::string_view key, bool may_be_zero) {
    const Distribution d = read_distribution(table, key, Dimension::length);
    const bool zero_limit = d.law == Law::exponential || d.law == Law::lognormal;
    if (d.infimum() < 0 || (d.infimum() == 0 && !may_be_zero && !zero_limit))
        table.fail(key,
                   d.law == Law::constant ? shortest_text(d.mean) + " m is too small"
                                          : "draws of " + std::string(key) + " may be zero or negative",
                   d.law == Law::constant ? (may_be_zero ? "zero or a positive length" : "a positive length")
                                          : "a min above zero");
    return d;
}

void check_spacing(const ConfigTable& table, const JointSet& set, double grid) {
    if (set.spacing.untruncated_mean() < 4 * grid ||
        (set.spacing.law == Law::constant && set.spacing.mean < 4 * grid))
        table.fail("spacing",
                   "a spacing of " + shortest_text(set.spacing.untruncated_mean()) + " m is below the grid",
                   "at least four times the grid of " + shortest_text(grid) + " m");
}

void read_bridges(const ConfigTable& table, JointSet& set) {
    if (!table.has("trace_length")) {
        if (table.has("gap") || table.has("persistence"))
            table.fail(table.has("gap") ? "gap" : "persistence",
                       "a rock bridge between joints of unlimited length", "trace_length as well");
        return;
    }
    set.trace_length = read_length(table, "trace_length", false);
    if (table.has("gap") == table.has("persistence"))
        table.fail(
            "trace_length", "traces of limited length need exactly one of gap and persistence",
            "gap, the rock bridge between two traces, or persistence, the share of the line that is open");
    if (table.has("gap")) {
        set.gap = read_length(table, "gap", true);
    } else {
        const double persistence = table.checked(
            "persistence", table.number("persistence"), [](double p) { return p > 0 && p <= 1; },
            "a share above 0, up to 1");
        set.gap = constant_value(set.trace_length->untruncated_mean() * (1 - persistence) / persistence);
    }
}

JointSet read_joint_set(const ConfigTable& table, const SlopeModel& model) {
    JointSet set;
    set.place = table.place();
    set.name = read_name(table, "name");
    table.choice("kind", {"parallel"}, "parallel");
    set.joint_material = table.string("joint_material", set.name);
    set.angle = read_distribution(table, "angle", Dimension::angle);
    set.spacing = read_length(table, "spacing", false);
    check_spacing(table, set, model.grid);
    read_bridges(table, set);
    if (table.has("origin")) set.origin = point_of(table.pair("origin", Dimension::length));
    set.region = table.string("region", "");
    const auto is_it = [&](const Region& region) { return region.name == set.region; };
    if (!set.region.empty() && std::none_of(model.regions.begin(), model.regions.end(), is_it))
        table.fail("region", "there is no region '" + set.region + "'", "the name of a [[region]]");
    for (const JointSet& other : model.joint_sets)
        if (other.name == set.name)
            table.fail("name", "a second joint set '" + set.name + "'", "a name for each joint set");
    return set;
}

void read_traces(const ConfigTable& table, SlopeModel& model) {
    const std::string fallback = "traces " + std::to_string(model.traces.size() + 1);
    const std::string material = table.string("joint_material", "");
    const std::string name = table.string("name", material.empty() ? fallback : material);
    if (table.has("points") == table.has("file"))
        table.fail("points", "traces need points or a file", "exactly one of them");
    if (table.has("file")) {
        model.files.push_back(table.file_path("file"));
        for (Trace& trace : read_trace_file(model.files.back(), name, material)) {
            check_reach(table, "file", trace.points, model);
            model.traces.push_back(std::move(trace));
        }
        return;
    }
    if (material.empty())
        table.fail("joint_material", "a trace without joint_material", "the name of a joint material");
    Trace trace{name, material, {}};
    for (const auto& pair : table.pairs("points", Dimension::length)) trace.points.push_back(point_of(pair));
    if (trace.points.size() < 2)
        table.fail("points", "a trace of fewer than two points", "two points or more");
    check_reach(table, "points", trace.points, model);
    model.traces.push_back(std::move(trace));
}

}  // namespace

void read_joints(const ConfigTable& root, SlopeModel& model) {
    for (const ConfigTable& table : root.array_of_tables("joint_set"))
        model.joint_sets.push_back(read_joint_set(table, model));
    for (const ConfigTable& table : root.array_of_tables("traces")) read_traces(table, model);
}

}  // namespace blockgen
