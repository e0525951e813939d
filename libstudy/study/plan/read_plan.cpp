#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/base/text.hpp"
#include "common/config/config_table.hpp"
#include "study/plan/plan.hpp"
#include "study/plan/read_factor.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

constexpr int most_rows = 10'000'000;

int count_in(const ConfigTable& table, const char* key, std::int64_t fallback, int low, int high) {
    const std::int64_t value = table.integer(key, fallback);
    table.checked(
        key, static_cast<double>(value), [=](double v) { return v >= low && v <= high; },
        "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return static_cast<int>(value);
}

double positive(const ConfigTable& table, const char* key, Dimension dimension) {
    return table.checked(
        key, table.number(key, dimension), [](double v) { return v > 0; }, "a positive number");
}

DesignKind read_kind(const ConfigTable& table) {
    const std::vector<std::pair<std::string, DesignKind>> kinds = {
        {"full", DesignKind::full},
        {"latin-hypercube", DesignKind::latin_hypercube},
        {"sobol", DesignKind::sobol},
        {"monte-carlo", DesignKind::monte_carlo},
        {"incremental", DesignKind::incremental},
        {"morris", DesignKind::morris},
        {"one-at-a-time", DesignKind::one_at_a_time}};
    std::vector<std::string> words;
    for (const auto& [word, kind] : kinds) words.push_back(word);
    const std::string word = table.choice("kind", words, "full");
    return std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == word; })->second;
}

Design read_design(const ConfigTable& table) {
    Design design;
    design.kind = read_kind(table);
    design.seed = static_cast<std::uint64_t>(count_in(table, "seed", 1, 0, most_rows));
    switch (design.kind) {
        case DesignKind::morris:
            design.samples = count_in(table, "trajectories", 10, 2, most_rows);
            design.levels = count_in(table, "levels", 4, 2, 1000);
            if (design.levels % 2 != 0) table.fail("levels", "'levels' is odd", "an even number");
            break;
        case DesignKind::sobol:
            design.indices = table.boolean("indices", false);
            [[fallthrough]];
        case DesignKind::latin_hypercube:
        case DesignKind::monte_carlo:
            design.samples =
                count_in(table, "samples", table.has("samples") ? 0 : table.integer("samples"), 1, most_rows);
            break;
        case DesignKind::incremental:
            design.intensity = table.string("intensity");
            design.measure = table.string("measure");
            design.limit = positive(table, "limit", Dimension::none);
            break;
        default:
            break;
    }
    table.finish();
    return design;
}

MeasureKind read_measure_kind(const ConfigTable& table) {
    const std::vector<std::pair<std::string, MeasureKind>> kinds = {
        {"displacement", MeasureKind::displacement},
        {"moved-volume", MeasureKind::moved_volume},
        {"front", MeasureKind::front},
        {"run-out", MeasureKind::run_out},
        {"travel-angle", MeasureKind::travel_angle},
        {"surface", MeasureKind::surface},
        {"deposit-height", MeasureKind::deposit_height},
        {"deposit-thickness", MeasureKind::deposit_thickness},
        {"first-slip", MeasureKind::first_slip},
        {"factor-of-safety", MeasureKind::factor_of_safety}};
    std::vector<std::string> words;
    for (const auto& [word, kind] : kinds) words.push_back(word);
    const std::string word = table.choice("kind", words, "displacement");
    return std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == word; })->second;
}

Measure read_measure(const ConfigTable& table, const std::vector<Measure>& before) {
    Measure measure;
    measure.name = table.string("name");
    for (const Measure& other : before)
        if (other.name == measure.name)
            table.fail("name", "there are two measures '" + measure.name + "'", "names that differ");
    measure.kind = read_measure_kind(table);
    if (measure.kind == MeasureKind::displacement) {
        measure.point = table.string("point", "");
        measure.region = table.string("region", "");
        if (!measure.point.empty() && !measure.region.empty())
            table.fail("region", "[" + table.path() + "] has 'point' and 'region'",
                       "one of them, or neither for the farthest block");
        measure.is_peak = table.choice("at", {"end", "peak"}, "end") == "peak";
        if (!measure.region.empty())
            measure.is_largest = table.choice("of", {"mean", "largest"}, "mean") == "largest";
    }
    const bool needs_limit = measure.kind == MeasureKind::moved_volume ||
                             measure.kind == MeasureKind::front || measure.kind == MeasureKind::run_out ||
                             measure.kind == MeasureKind::travel_angle ||
                             measure.kind == MeasureKind::deposit_thickness;
    if (needs_limit) measure.limit = positive(table, "limit", Dimension::length);
    const bool may_have_station =
        measure.kind == MeasureKind::deposit_height || measure.kind == MeasureKind::deposit_thickness;
    if (measure.kind == MeasureKind::surface || (may_have_station && table.has("x")))
        measure.x = table.number("x", Dimension::length);
    if (measure.kind == MeasureKind::deposit_height && !measure.x)
        measure.width = positive(table, "width", Dimension::length);
    table.finish();
    return measure;
}

FragilityPlan read_fragility(const ConfigTable& table, const std::vector<Measure>& measures) {
    FragilityPlan fragility;
    std::vector<std::string> names;
    for (const Measure& measure : measures) names.push_back(measure.name);
    fragility.measure = table.choice("measure", names);
    fragility.intensity = table.string("intensity");
    fragility.limit = positive(table, "limit", Dimension::none);
    fragility.by_demands = table.choice("method", {"outcomes", "demands"}, "outcomes") == "demands";
    table.finish();
    return fragility;
}

std::optional<ProfilePlan> read_profile(const ConfigTable& root) {
    if (!root.has("profile")) return std::nullopt;
    const ConfigTable table = root.table("profile");
    const ProfilePlan profile{positive(table, "interval", Dimension::length),
                              positive(table, "limit", Dimension::length)};
    table.finish();
    return profile;
}

RowOutput read_row_output(const ConfigTable& table) {
    RowOutput output;
    output.frames = count_in(table, "frames", output.frames, 0, 1'000'000);
    output.joint_frames = table.boolean("joint_frames", output.joint_frames);
    output.step_log = table.boolean("step_log", output.step_log);
    output.history_interval = table.checked(
        "history_interval", table.number("history_interval", Dimension::time, output.history_interval),
        [](double v) { return v == 0 || v >= 1e-9; }, "0, for every step, or a time of 1e-9 s or more");
    return output;
}

/// Overrides "slope:KEY=VALUE" and "run:KEY=VALUE" of all rows.
void read_set(const ConfigTable& root, Plan& plan) {
    if (!root.has("set")) return;
    for (const std::string& text : root.strings("set")) {
        const std::size_t colon = text.find(':');
        const std::string file = text.substr(0, colon);
        if (colon == std::string::npos || (file != "slope" && file != "run"))
            root.fail("set", "'" + text + "' names no key", "\"slope:KEY=VALUE\" or \"run:KEY=VALUE\"");
        (file == "slope" ? plan.slope_set : plan.run_set).push_back(text.substr(colon + 1));
    }
}

void check_paired(const ConfigTable& table, const Factor& factor, const std::vector<Factor>& before) {
    if (factor.paired_with.empty()) return;
    for (const Factor& other : before) {
        if (other.name != factor.paired_with) continue;
        if (other.distribution || factor.distribution || other.values.size() != factor.values.size())
            table.fail("pair",
                       "'" + factor.name + "' has " + std::to_string(factor.values.size()) + " values, '" +
                           other.name + "' has " + std::to_string(other.values.size()),
                       "as many values in both, and no distribution");
    }
}

void check_design(const ConfigTable& table, const Plan& plan) {
    const Design& design = plan.design;
    for (const Factor& factor : plan.factors) {
        const bool lists_values = design.kind == DesignKind::full || design.kind == DesignKind::incremental;
        if (lists_values && factor.distribution)
            table.fail(
                "kind",
                "the factor '" + factor.name + "' is a distribution, which this design does not draw from",
                "values for it, or a sampled design");
    }
    if (design.kind != DesignKind::incremental) return;
    const auto is_intensity = [&](const Factor& f) { return f.name == design.intensity; };
    const auto factor = std::find_if(plan.factors.begin(), plan.factors.end(), is_intensity);
    if (factor == plan.factors.end())
        table.fail("intensity", "there is no factor '" + design.intensity + "'", "the name of a [[factor]]");
    if (!factor->scale)
        table.fail("intensity", "the factor '" + design.intensity + "' scales no record",
                   "a factor with 'scale'");
    if (!std::is_sorted(factor->intensities.begin(), factor->intensities.end()))
        table.fail("intensity", "the values of '" + design.intensity + "' do not increase",
                   "increasing values");
    const auto is_measure = [&](const Measure& m) { return m.name == design.measure; };
    if (std::none_of(plan.measures.begin(), plan.measures.end(), is_measure))
        table.fail("measure", "there is no measure '" + design.measure + "'", "the name of a [[measure]]");
}

void read_models(const ConfigTable& root, Plan& plan) {
    if (root.has("slope") == root.has("blocks"))
        root.fail("slope",
                  "the plan has " + std::string(root.has("slope") ? "'slope' and 'blocks'"
                                                                  : "neither 'slope' nor 'blocks'"),
                  "one of them: a model to cut, or a block file for all rows");
    if (root.has("slope")) plan.slope = root.file_path("slope");
    if (root.has("blocks")) plan.blocks = root.file_path("blocks");
    plan.run = root.file_path("run");
}

}  // namespace

std::size_t Plan::index_of(const std::string& factor) const {
    for (std::size_t k = 0; k < factors.size(); ++k)
        if (factors[k].name == factor) return k;
    throw std::out_of_range("no factor " + factor);
}

Plan read_plan(const fs::path& file) {
    const fs::path absolute = fs::absolute(file).lexically_normal();
    const ConfigTable root = ConfigTable::from_file(absolute);
    Plan plan;
    plan.file = absolute;
    read_models(root, plan);
    read_set(root, plan);
    plan.replicates = count_in(root, "replicates", 1, 1, 1'000'000);
    for (const ConfigTable& table : root.array_of_tables("factor")) {
        const Factor factor = read_factor(table, plan.factors, absolute.parent_path());
        check_paired(table, factor, plan.factors);
        for (const Target& target : factor.targets)
            if (target.file == ModelFile::slope && plan.slope.empty())
                table.fail("key",
                           "the factor '" + factor.name + "' changes the slope, and the plan has 'blocks'",
                           "'slope' in the plan");
        plan.factors.push_back(factor);
    }
    for (const ConfigTable& table : root.array_of_tables("measure"))
        plan.measures.push_back(read_measure(table, plan.measures));
    for (const ConfigTable& table : root.array_of_tables("fragility"))
        plan.fragilities.push_back(read_fragility(table, plan.measures));
    const ConfigTable design = root.table_or_empty("design");
    plan.design = read_design(design);
    check_design(design, plan);
    plan.profile = read_profile(root);
    plan.output = read_row_output(root.table_or_empty("output"));
    if (root.has("row_time")) plan.row_time = positive(root, "row_time", Dimension::time);
    root.finish();
    return plan;
}

}  // namespace rockslope::study
