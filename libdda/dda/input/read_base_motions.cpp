#include <algorithm>

#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"
#include "dda/input/base_acceleration.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_stages.hpp"

namespace rockslope::dda {

namespace {

constexpr double max_channels = 1e9;
constexpr double max_drift_steps = 1e8;  // each costs a few nanoseconds

int channel_of(const ConfigTable& axis) {
    const std::int64_t channel = axis.integer("channel");
    axis.checked(
        "channel", static_cast<double>(channel), [](double v) { return v >= 1 && v <= max_channels; },
        "a whole number from 1");
    return channel;
}

/// The acceleration of one axis, m/s2, from a record or from { times, values }, delayed by `delay`, s.
TimeTable read_axis(const ConfigTable& axis, double step, double delay, InputFiles& files) {
    const double scale = axis.number("scale", Dimension::none, 1.0);
    TimeTable table;
    if (axis.has("file")) {
        const record::Record record = read_axis_record(axis, files);
        table = acceleration_of(record, scale, axis.place("file"));
    } else {
        table = read_time_table(axis, Dimension::acceleration, files);
        std::vector<double> values = table.values();
        for (double& value : values) value *= scale;
        table = with_zero_end(TimeTable(table.times(), std::move(values)));
    }
    table = delayed(table, delay);
    if (!std::all_of(table.values().begin(), table.values().end(), is_in_allowed_range))
        axis.fail("scale", "the accelerations of [" + axis.path() + "] are too large",
                  "magnitudes up to 1e30 m/s2");
    if (axis.choice("baseline", {"none", "drift"}, "none") == "none") return table;
    if (table.times().back() > max_drift_steps * step)
        axis.fail("baseline", "the record is too long to correct its drift",
                  "at most " + shortest_text(max_drift_steps) + " steps");
    if (table.times().back() < 2 * step)
        axis.fail("baseline", "the record is too short to correct its drift",
                  "at least two steps of " + shortest_text(step) + " s");
    return baseline_corrected(table, step);
}

/// Zero acceleration, for an axis without a table.
TimeTable at_rest() {
    return {{0.0}, {0.0}};
}

void check_block(const ConfigTable& table, const std::string& block, const Model& model) {
    std::vector<std::string> names;
    for (const BlockIndex i : model.blocks())
        if (model.motion[i] == Motion::prescribed &&
            std::find(names.begin(), names.end(), model.block_name[i]) == names.end())
            names.push_back(model.block_name[i]);
    if (std::find(names.begin(), names.end(), block) != names.end()) return;
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    table.fail("block", "there is no prescribed block '" + block + "' in the block file",
               names.empty() ? "a [[prescribed_block]] in the section's model file" : "one of " + known);
}

void check_base(const ConfigTable& table, const std::string& block, const Model& model) {
    if (!block.empty()) check_block(table, block, model);
    const bool any_base =
        std::find(model.motion.begin(), model.motion.end(), Motion::prescribed) != model.motion.end();
    if (!any_base)
        table.fail("block", "the block file has no prescribed block, so no base can move",
                   "a [[prescribed_block]] in the section's model file, or way = \"body-force\"");
}

void read_base_motion(const ConfigTable& table, const Model& model, InputFiles& files, Stage& stage) {
    const bool is_body_force =
        table.choice("way", {"prescribed", "body-force"}, "prescribed") == "body-force";
    BaseMotion motion{is_body_force ? "" : table.string("block", ""), at_rest(), at_rest()};
    if (!is_body_force) check_base(table, motion.block, model);
    const double delay = not_negative(table, "delay", Dimension::time, 0);
    const double step = stage.control.step;
    if (const auto axis = table.optional_table("x")) motion.x = read_axis(*axis, step, delay, files);
    if (const auto axis = table.optional_table("y")) motion.y = read_axis(*axis, step, delay, files);
    (is_body_force ? stage.frame_motions : stage.base_motions).push_back(std::move(motion));
}

}  // namespace

record::Record read_axis_record(const ConfigTable& axis, InputFiles& files) {
    record::RecordDeclaration declaration;
    if (axis.has("quantity"))
        declaration.quantity =
            record::quantity_of_name(axis.choice("quantity", {"acceleration", "velocity", "displacement"}));
    if (axis.has("unit")) declaration.unit = axis.string("unit");
    if (axis.has("format")) declaration.format = axis.choice("format", record::record_format_keys());
    if (axis.has("channel")) declaration.channel = channel_of(axis);
    if (axis.has("point")) declaration.point = axis.string("point");
    files.push_back(axis.file_path("file"));
    return record::read_record(files.back(), declaration);
}

TimeTable delayed(const TimeTable& table, double delay) {
    if (delay == 0) return table;
    std::vector<double> times = table.times();
    for (double& time : times) time += delay;
    return {std::move(times), table.values()};
}

void read_base_motions(const ConfigTable& table, const Model& model, InputFiles& files, Stage& stage) {
    if (table.is_table("base_motion"))
        return read_base_motion(table.table("base_motion"), model, files, stage);
    for (const ConfigTable& motion : table.array_of_tables("base_motion"))
        read_base_motion(motion, model, files, stage);
}

}  // namespace rockslope::dda
