#include <algorithm>
#include <cmath>
#include <numbers>

#include "blockgen/input/csv_table.hpp"
#include "blockgen/input/read_distribution.hpp"
#include "blockgen/input/read_section.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "common/base/degree.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

SetKind read_kind(const ConfigTable& table) {
    const std::string word =
        table.choice("kind", {"parallel", "baecher", "veneziano", "cross-jointed", "voronoi"}, "parallel");
    if (word == "baecher") return SetKind::baecher;
    if (word == "veneziano") return SetKind::veneziano;
    if (word == "cross-jointed") return SetKind::cross_jointed;
    return word == "voronoi" ? SetKind::voronoi : SetKind::parallel;
}

double check_dip(const ConfigTable& table, std::string_view key, double dip) {
    return table.checked(
        key, dip, [](double d) { return d >= 0 && d <= std::numbers::pi / 2 + 1e-12; },
        "a dip from 0 to 90 deg");
}

/// Poles of planes in space: one given by dip and dip direction, or a list of measured ones.
std::vector<Pole> read_poles(const ConfigTable& table, double azimuth, SlopeModel& model) {
    std::vector<Pole> poles;
    if (table.has("dip") || table.has("dip_direction")) {
        const double dip = check_dip(table, "dip", table.number("dip", Dimension::angle));
        poles.push_back(pole_of(dip, table.number("dip_direction", Dimension::angle), azimuth));
    } else if (table.has("orientations")) {
        for (const auto& [dip, direction] : table.pairs("orientations", Dimension::angle))
            poles.push_back(pole_of(check_dip(table, "orientations", dip), direction, azimuth));
    } else {
        model.files.push_back(table.file_path("orientation_file"));
        const CsvTable rows = read_csv(model.files.back(), {"dip", "dip_direction"}, {});
        for (std::size_t k = 0; k < rows.row_count(); ++k) {
            if (!(rows.number(k, 0) >= 0 && rows.number(k, 0) <= 90))
                throw InputError({model.files.back().string(), rows.lines[k]},
                                 "a dip of " + shortest_text(rows.number(k, 0)) + " degrees", "0 to 90");
            poles.push_back(pole_of(degree * rows.number(k, 0), degree * rows.number(k, 1), azimuth));
        }
    }
    if (poles.empty())
        table.fail(table.has("orientations") ? "orientations" : "orientation_file", "no orientation",
                   "pairs of dip and dip direction");
    return poles;
}

Orientation read_orientation(const ConfigTable& table, SlopeModel& model) {
    Orientation orientation;
    const bool by_dip = table.has("dip") || table.has("dip_direction");
    const int given = int{table.has("angle")} + int{by_dip} + int{table.has("orientations")} +
                      int{table.has("orientation_file")};
    if (given > 1)
        table.fail("angle", "several orientations are given",
                   "exactly one of angle, dip, orientations and orientation_file");
    if (table.has("angle") || given == 0) {
        orientation.angle = read_distribution(table, "angle", Dimension::angle);
        return orientation;
    }
    if (!model.section)
        table.fail(by_dip ? "dip" : "orientations", "planes in space without a section that cuts them",
                   "[section] with its azimuth");
    orientation.poles = read_poles(table, model.section->azimuth, model);
    if (by_dip && table.has("fisher_k"))
        orientation.fisher_k = table.checked(
            "fisher_k", table.number("fisher_k"), [](double k) { return k > 0; },
            "a positive concentration: 20 gives a wide scatter, 200 a narrow one");
    orientation.weighted_by_section = table.choice("weighting", {"none", "section"}, "none") == "section";
    if (!(orientation.spacing_factor() < 1e6))
        table.fail(by_dip ? "dip" : "orientations", "the set lies parallel to the section",
                   "planes that the section cuts");
    return orientation;
}

/// Converts true spacings, across planes in space, to spacings in the section.
Distribution in_section(Distribution spacing, double factor) {
    spacing.mean *= factor;
    spacing.sd *= factor;
    spacing.min *= factor;
    spacing.max *= factor;
    return spacing;
}

void read_spacing(const ConfigTable& table, JointSet& set, double grid) {
    set.spacing = read_length(table, "spacing", false);
    if (set.spacing.untruncated_mean() < 4 * grid)
        table.fail("spacing",
                   "a spacing of " + shortest_text(set.spacing.untruncated_mean()) + " m is below the grid",
                   "at least four times the grid of " + shortest_text(grid) + " m");
    set.spacing = in_section(set.spacing, set.orientation.spacing_factor());
    if (table.has("origin")) set.origin = point_of(table.pair("origin", Dimension::length));
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
            "gap, the rock bridge between two traces, or persistence, the fraction of the line that is "
            "jointed");
    if (table.has("gap")) {
        set.gap = read_length(table, "gap", true);
        return;
    }
    const double persistence = table.checked(
        "persistence", table.number("persistence"), [](double p) { return p > 0 && p <= 1; },
        "a fraction above 0, up to 1");
    const double gap = set.trace_length->truncated_mean() * (1 - persistence) / persistence;
    // Veneziano's lines are divided at random points, so the lengths of the bridges are exponential.
    set.gap =
        set.kind == SetKind::veneziano && gap > 0 ? Distribution{Law::exponential, gap} : constant_value(gap);
}

StopRule read_stop(const ConfigTable& table,
                   const std::vector<std::pair<std::string, StopRule::Measure>>& words) {
    StopRule stop;
    std::string names;
    for (const auto& [word, measure] : words) {
        names += (names.empty() ? "" : ", ") + word;
        if (!table.has(word)) continue;
        if (stop.measure != StopRule::Measure::none)
            table.fail(word, "the set has a second stop rule", "one of " + names);
        stop = {measure, table.checked(
                             word, table.number(word), [](double x) { return x > 0; }, "a positive number")};
    }
    if (stop.measure == StopRule::Measure::none)
        table.fail("kind", "the set has no stop rule", "one of " + names);
    return stop;
}

/// @throws InputError when the name is that of traces of which none is left.
void refuse_repeated(const ConfigTable& table, std::string_view key, const std::string& name,
                     const SlopeModel& model) {
    if (std::find(model.repeated_names.begin(), model.repeated_names.end(), name) !=
        model.repeated_names.end())
        table.fail(key, "all traces '" + name + "' repeat earlier ones and are dropped",
                   "the name of the traces that they repeat");
}

void read_cross_jointed(const ConfigTable& table, JointSet& set, const SlopeModel& model) {
    const auto is_fraction = [](double x) { return x >= 0 && x <= 1; };
    set.ends_on = read_name(table, "ends_on");
    refuse_repeated(table, "ends_on", set.ends_on, model);
    const auto has_name = [&](const auto& joints) { return joints.name == set.ends_on; };
    if (std::none_of(model.joint_sets.begin(), model.joint_sets.end(), has_name) &&
        std::none_of(model.traces.begin(), model.traces.end(), has_name))
        table.fail("ends_on", "there are no joints '" + set.ends_on + "' before this set",
                   "the name of traces or of an earlier [[joint_set]]");
    set.termination = table.checked("termination", table.number("termination", Dimension::none, 1),
                                    is_fraction, "a probability from 0 to 1");
    set.stagger = table.checked("stagger", table.number("stagger", Dimension::none, 0.5), is_fraction,
                                "a fraction of the spacing, from 0 to 1");
}

void read_voronoi(const ConfigTable& table, JointSet& set) {
    set.stop = read_stop(table, {{"count", StopRule::Measure::count}});
    const auto relaxation = table.integer("relaxation", 0);
    if (relaxation < 0 || relaxation > 1000)
        table.fail("relaxation", "too few or too many rounds",
                   "0 (random cells) to 1000 (nearly hexagonal cells)");
    set.relaxation = relaxation;
}

/// The mapped traces of a set whose joints lie anywhere.
void read_condition(const ConfigTable& table, JointSet& set, const SlopeModel& model) {
    if (!table.has("conditioned_on")) {
        if (table.has("mapped_area"))
            table.fail("mapped_area", "a mapped area without mapped traces", "conditioned_on, their name");
        return;
    }
    set.conditioned_on = read_name(table, "conditioned_on");
    refuse_repeated(table, "conditioned_on", set.conditioned_on, model);
    const auto has_name = [&](const Trace& trace) { return trace.name == set.conditioned_on; };
    if (std::none_of(model.traces.begin(), model.traces.end(), has_name))
        table.fail("conditioned_on", "there are no traces '" + set.conditioned_on + "'",
                   "the name of [[traces]]");
    if (!table.has("mapped_area")) return;
    if (table.has("region")) table.fail("mapped_area", "a mapped area and a region", "one of them");
    set.mapped_area = read_ring(table, "mapped_area");
    check_coordinate_range(table, "mapped_area", set.mapped_area, model);
}

void read_members(const ConfigTable& table, JointSet& set, SlopeModel& model) {
    using Measure = StopRule::Measure;
    if (set.kind == SetKind::voronoi) return read_voronoi(table, set);
    set.orientation = read_orientation(table, model);
    if (set.kind == SetKind::baecher || set.kind == SetKind::veneziano) read_condition(table, set, model);
    if (set.kind == SetKind::baecher) {
        set.trace_length = read_length(table, "trace_length", false);
        set.stop = read_stop(
            table,
            {{"p10", Measure::p10}, {"p20", Measure::p20}, {"p21", Measure::p21}, {"count", Measure::count}});
        return;
    }
    if (set.kind == SetKind::veneziano)
        set.stop =
            read_stop(table, {{"p10", Measure::p10}, {"p21", Measure::p21}, {"count", Measure::count}});
    else
        read_spacing(table, set, model.grid);
    if (set.kind == SetKind::cross_jointed)
        read_cross_jointed(table, set, model);
    else
        read_bridges(table, set);
}

JointSet read_joint_set(const ConfigTable& table, SlopeModel& model) {
    JointSet set;
    set.place = table.place();
    set.name = read_name(table, "name");
    set.kind = read_kind(table);
    set.joint_material = table.string("joint_material", set.name);
    read_members(table, set, model);
    set.region = table.string("region", "");
    const auto has_name = [&](const Region& region) { return region.name == set.region; };
    if (!set.region.empty() && std::none_of(model.regions.begin(), model.regions.end(), has_name))
        table.fail("region", "there is no region '" + set.region + "'",
                   "the name of a [[region]], [[layer]] or [weathered] zone");
    for (const JointSet& other : model.joint_sets)
        if (other.name == set.name)
            table.fail("name", "a second joint set '" + set.name + "'", "a name for each joint set");
    return set;
}

}  // namespace

void read_joint_sets(const ConfigTable& root, SlopeModel& model) {
    read_section(root, model);
    for (const ConfigTable& table : root.array_of_tables("joint_set"))
        model.joint_sets.push_back(read_joint_set(table, model));
}

}  // namespace rockslope::blockgen
