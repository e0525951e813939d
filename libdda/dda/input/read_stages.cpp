#include "dda/input/read_stages.hpp"

#include <algorithm>
#include <optional>

#include "common/base/text.hpp"
#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

constexpr int largest_count = 1'000'000'000;

double in_range(const ConfigTable& table, std::string_view key, double fallback, double low, double high,
                const std::string& expected) {
    const double value = table.number(key, Dimension::none, fallback);
    return table.checked(
        key, value, [=](double v) { return v >= low && v <= high; }, expected);
}

int count(const ConfigTable& table, std::string_view key, int fallback) {
    const std::int64_t value = table.integer(key, fallback);
    table.checked(
        key, static_cast<double>(value), [](double v) { return v >= 1 && v <= largest_count; },
        "a whole number from 1");
    return value;
}

/// A positive time, s. Beyond thirty years the clock of a run would stand still.
double time_of(const ConfigTable& table, const char* key, std::optional<double> missing = std::nullopt) {
    constexpr double longest_time = 1e9;
    const double time =
        missing ? positive(table, key, Dimension::time, *missing) : positive(table, key, Dimension::time);
    return table.checked(
        key, time, [](double v) { return v <= longest_time; }, "a time of at most 1e9 s");
}

StepControl read_step_control(const ConfigTable& table) {
    StepControl control;
    control.step = time_of(table, "step", control.step);
    control.smallest_step = positive(table, "smallest_step", Dimension::time, control.smallest_step);
    control.cut = table.checked(
        "cut", table.number("cut", Dimension::none, control.cut), [](double v) { return v > 0 && v < 1; },
        "a factor between 0 and 1");
    control.growth = in_range(table, "growth", control.growth, 1, 1e6, "a factor of at least 1");
    control.iteration_limit = count(table, "iteration_limit", control.iteration_limit);
    control.displacement_ratio =
        positive(table, "displacement_ratio", Dimension::none, control.displacement_ratio);
    control.force_tolerance = positive(table, "force_tolerance", Dimension::none, control.force_tolerance);
    if (control.smallest_step > control.step)
        table.fail("smallest_step", "'smallest_step' in [" + table.path() + "] is larger than the step",
                   "at most " + shortest_text(control.step) + " s");
    return control;
}

double height_of(const Model& model) {
    double low = model.vertices.front().y(), high = low;
    for (const Vec2& v : model.vertices) {
        low = std::min(low, v.y());
        high = std::max(high, v.y());
    }
    return high - low;
}

/// Default displacement limits of static stages and of the trials of a strength reduction, over the model's
/// height.
constexpr double settling_displacement_ratio = 0.05;
constexpr double failure_displacement_ratio = 0.01;

StrengthReduction read_strength_reduction(const ConfigTable& table, const Model& model) {
    StrengthReduction search;
    search.lowest = in_range(table, "lowest_factor", search.lowest, 1e-3, 1, "a factor from 0.001 to 1");
    search.highest = in_range(table, "highest_factor", search.highest, 1, 1e3, "a factor from 1 to 1000");
    search.width = in_range(table, "factor_tolerance", search.width, 1e-6, 1, "a ratio from 1e-6 to 1");
    search.displacement_limit = positive(table, "displacement_limit", Dimension::length,
                                         failure_displacement_ratio * height_of(model));
    return search;
}

/// The end of the latest record of a stage, s.
double duration_of_records(const ConfigTable& table, const Stage& stage) {
    double end = 0;
    for (const auto* motions : {&stage.base_motions, &stage.frame_motions})
        for (const BaseMotion& motion : *motions)
            end = std::max({end, motion.x.times().back(), motion.y.times().back()});
    for (const IncidentWave& wave : stage.incident_waves)
        end = std::max({end, wave.x.times().back(), wave.y.times().back()});
    if (!(end > 0))
        table.fail("duration", "the stage has no record to last as long as",
                   "a record in [stage.base_motion], or a time such as \"20 s\"");
    return end;
}

Stage read_stage(const ConfigTable& table, std::size_t index, const Model& model, InputFiles& files) {
    Stage stage;
    stage.name = table.string("name", "stage " + std::to_string(index + 1));
    const std::string kind = table.choice("kind", {"static", "dynamic", "strength-reduction"});
    stage.kind = kind == "dynamic" ? StageKind::dynamic : StageKind::static_equilibrium;
    stage.control = read_step_control(table);
    stage.mass_damping = not_negative(table, "mass_damping", Dimension::none, 0);
    if (stage.is_static()) {
        stage.tolerance = positive(table, "tolerance", Dimension::none, stage.tolerance);
        stage.step_limit = count(table, "step_limit", stage.step_limit);
        stage.bonds_break_at_rest =
            table.choice("bonds_break", {"at-rest", "at-once"}, "at-rest") == "at-rest";
        stage.moving_share = in_range(table, "moving_share", stage.moving_share, 0, 1, "a share from 0 to 1");
        if (kind == "strength-reduction") {
            stage.strength_reduction = read_strength_reduction(table, model);
            stage.reset_displacements = false;
            return stage;
        }
        stage.stop = read_stop_limit(table, model);
        stage.displacement_limit = positive(table, "displacement_limit", Dimension::length,
                                            settling_displacement_ratio * height_of(model));
        stage.remove_moving = table.choice("moving_blocks", {"keep", "remove"}, "keep") == "remove";
        stage.reset_displacements = table.boolean("reset_displacements", stage.reset_displacements);
        stage.reset_joint_history = table.boolean("reset_joint_history", stage.reset_joint_history);
        return stage;
    }
    stage.stop = read_stop_limit(table, model);
    const bool lasts_as_record = table.is_string("duration") && table.string("duration") == "record";
    if (!lasts_as_record) stage.duration = time_of(table, "duration");
    stage.dynamic_coefficient =
        in_range(table, "dynamic_coefficient", stage.dynamic_coefficient, 0, 1, "a number from 0 to 1");
    stage.newmark_beta =
        in_range(table, "newmark_beta", stage.newmark_beta, 1e-3, 1, "a number from 0.001 to 1");
    stage.newmark_gamma =
        in_range(table, "newmark_gamma", stage.newmark_gamma, 0.5, 1, "a number from 0.5 to 1");
    stage.perturbation = table.integer("perturbation", 0);
    table.checked(
        "perturbation", static_cast<double>(stage.perturbation), [](double v) { return v >= 0; },
        "0, or the seed of a perturbation");
    stage.incident_waves = read_incident_waves(table, model, files);
    read_base_motions(table, model, files, stage);
    if (lasts_as_record) stage.duration = duration_of_records(table, stage);
    return stage;
}

}  // namespace

std::vector<Stage> read_stages(const ConfigTable& run, const Model& model, InputFiles& files) {
    std::vector<Stage> stages;
    for (const ConfigTable& table : run.array_of_tables("stage"))
        stages.push_back(read_stage(table, stages.size(), model, files));
    if (stages.empty()) throw InputError(run.place(), "there is no stage", "at least one [[stage]]");
    return stages;
}

}  // namespace rockslope::dda
