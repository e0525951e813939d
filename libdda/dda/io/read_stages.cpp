#include "dda/io/read_stages.hpp"

#include <algorithm>

#include "blockgen/base/magnitude.hpp"
#include "blockgen/base/text.hpp"
#include "dda/io/base_acceleration.hpp"
#include "dda/io/read_boundaries.hpp"
#include "dda/io/read_materials.hpp"

namespace dda {

using blockgen::ConfigTable;
using blockgen::Dimension;

namespace {

constexpr int largest_count = 1'000'000'000;
constexpr double most_drift_steps = 1e8;  // each costs a few nanoseconds

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
    return static_cast<int>(value);
}

StepControl read_step_control(const ConfigTable& table) {
    StepControl control;
    control.step = positive(table, "step", Dimension::time, control.step);
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
                   "at most " + blockgen::shortest_text(control.step) + " s");
    return control;
}

Record read_axis_record(const ConfigTable& axis, InputFiles& files) {
    RecordDeclaration declaration;
    if (axis.has("quantity"))
        declaration.quantity =
            quantity_of_name(axis.choice("quantity", {"acceleration", "velocity", "displacement"}));
    if (axis.has("unit")) declaration.unit = axis.string("unit");
    if (axis.has("format")) declaration.format = axis.choice("format", record_format_keys());
    if (axis.has("channel")) declaration.channel = count(axis, "channel", 1);
    if (axis.has("point")) declaration.point = axis.string("point");
    files.push_back(axis.file_path("file"));
    return read_record(files.back(), declaration);
}

/// The acceleration of one axis: from a record, or from { times, values } in m/s2.
TimeTable read_axis(const ConfigTable& axis, double step, InputFiles& files) {
    const double scale = axis.number("scale", Dimension::none, 1.0);
    TimeTable table;
    if (axis.has("file")) {
        const Record record = read_axis_record(axis, files);
        table = acceleration_of(record, scale, axis.place("file"));
    } else {
        table = read_time_table(axis, Dimension::acceleration, files);
        std::vector<double> values = table.values();
        for (double& value : values) value *= scale;
        table = ending_in_zero(TimeTable(table.times(), std::move(values)));
    }
    if (!std::all_of(table.values().begin(), table.values().end(), blockgen::is_usable))
        axis.fail("scale", "the accelerations of [" + axis.path() + "] are too large", "a ground motion");
    if (axis.choice("baseline", {"none", "drift"}, "none") == "none") return table;
    if (table.times().back() > most_drift_steps * step)
        axis.fail("baseline", "the record is too long to correct its drift",
                  "at most " + blockgen::shortest_text(most_drift_steps) + " steps");
    if (table.times().back() < 2 * step)
        axis.fail("baseline", "the record is too short to correct its drift",
                  "at least two steps of " + blockgen::shortest_text(step) + " s");
    return without_drift(table, step);
}

/// An axis without a table stays at rest.
TimeTable at_rest() {
    return {{0.0}, {0.0}};
}

void check_block(const ConfigTable& table, const std::string& block, const Model& model) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model.motion.size(); ++i)
        if (model.motion[i] == Motion::prescribed &&
            std::find(names.begin(), names.end(), model.block_name[i]) == names.end())
            names.push_back(model.block_name[i]);
    if (std::find(names.begin(), names.end(), block) != names.end()) return;
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    table.fail("block", "there is no prescribed block '" + block + "' in the block file",
               names.empty() ? "a [[prescribed_block]] in the section's model file" : "one of " + known);
}

BaseMotion read_base_motion(const ConfigTable& table, double step, const Model& model, InputFiles& files) {
    BaseMotion motion{table.string("block", ""), at_rest(), at_rest()};
    if (!motion.block.empty()) check_block(table, motion.block, model);
    const bool any_base =
        std::find(model.motion.begin(), model.motion.end(), Motion::prescribed) != model.motion.end();
    if (!any_base)
        table.fail("block", "the block file has no prescribed block, so no base can move",
                   "a [[prescribed_block]] in the section's model file");
    if (const auto axis = table.optional_table("x")) motion.x = read_axis(*axis, step, files);
    if (const auto axis = table.optional_table("y")) motion.y = read_axis(*axis, step, files);
    return motion;
}

std::vector<BaseMotion> read_base_motions(const ConfigTable& stage, double step, const Model& model,
                                          InputFiles& files) {
    std::vector<BaseMotion> motions;
    if (stage.is_table("base_motion"))
        motions.push_back(read_base_motion(stage.table("base_motion"), step, model, files));
    else
        for (const ConfigTable& table : stage.array_of_tables("base_motion"))
            motions.push_back(read_base_motion(table, step, model, files));
    return motions;
}

double height_of(const Model& model) {
    double low = model.vertices.front().y(), high = low;
    for (const Vec2& v : model.vertices) {
        low = std::min(low, v.y());
        high = std::max(high, v.y());
    }
    return high - low;
}

StrengthReduction read_strength_reduction(const ConfigTable& table, const Model& model) {
    constexpr double failed_share = 0.01;  // of the model's height
    StrengthReduction search;
    search.lowest = in_range(table, "lowest_factor", search.lowest, 1e-3, 1, "a factor from 0.001 to 1");
    search.highest = in_range(table, "highest_factor", search.highest, 1, 1e3, "a factor from 1 to 1000");
    search.width = in_range(table, "factor_tolerance", search.width, 1e-6, 1, "a ratio from 1e-6 to 1");
    search.displacement_limit =
        positive(table, "displacement_limit", Dimension::length, failed_share * height_of(model));
    return search;
}

Stage read_stage(const ConfigTable& table, std::size_t index, const Model& model, InputFiles& files) {
    Stage stage;
    stage.name = table.string("name", "stage " + std::to_string(index + 1));
    const std::string kind = table.choice("kind", {"static", "dynamic", "strength-reduction"});
    stage.kind = kind == "dynamic" ? StageKind::dynamic : StageKind::static_equilibrium;
    stage.control = read_step_control(table);
    stage.mass_damping = not_negative(table, "mass_damping", Dimension::none, 0);
    if (stage.kind == StageKind::static_equilibrium) {
        stage.tolerance = positive(table, "tolerance", Dimension::none, stage.tolerance);
        stage.step_limit = count(table, "step_limit", stage.step_limit);
        if (kind == "strength-reduction") {
            stage.strength_reduction = read_strength_reduction(table, model);
            stage.reset_displacements = false;
            return stage;
        }
        stage.reset_displacements = table.boolean("reset_displacements", stage.reset_displacements);
        stage.reset_joint_history = table.boolean("reset_joint_history", stage.reset_joint_history);
        return stage;
    }
    stage.duration = positive(table, "duration", Dimension::time);
    stage.dynamic_coefficient =
        in_range(table, "dynamic_coefficient", stage.dynamic_coefficient, 0, 1, "a number from 0 to 1");
    stage.newmark_beta =
        in_range(table, "newmark_beta", stage.newmark_beta, 1e-3, 1, "a number from 0.001 to 1");
    stage.newmark_gamma =
        in_range(table, "newmark_gamma", stage.newmark_gamma, 0.5, 1, "a number from 0.5 to 1");
    stage.incident_waves = read_incident_waves(table, model, files);
    stage.base_motions = read_base_motions(table, stage.control.step, model, files);
    return stage;
}

}  // namespace

std::vector<Stage> read_stages(const ConfigTable& run, const Model& model, InputFiles& files) {
    std::vector<Stage> stages;
    for (const ConfigTable& table : run.array_of_tables("stage"))
        stages.push_back(read_stage(table, stages.size(), model, files));
    if (stages.empty())
        throw blockgen::InputError(run.place(), "there is no stage", "at least one [[stage]]");
    return stages;
}

}  // namespace dda
