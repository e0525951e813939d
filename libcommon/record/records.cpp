#include "record/records.hpp"

#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

struct UnitRow {
    Quantity quantity;
    const char* name;
    double factor;
};

constexpr UnitRow units[] = {
    {Quantity::acceleration, "g", 9.80665},
    {Quantity::acceleration, "m/s2", 1},
    {Quantity::acceleration, "m/s/s", 1},
    {Quantity::acceleration, "m/sec2", 1},
    {Quantity::acceleration, "cm/s2", 1e-2},
    {Quantity::acceleration, "cm/s/s", 1e-2},
    {Quantity::acceleration, "cm/sec2", 1e-2},
    {Quantity::acceleration, "mm/s2", 1e-3},
    {Quantity::acceleration, "gal", 1e-2},
    {Quantity::acceleration, "cm/sec/sec", 1e-2},
    {Quantity::velocity, "m/s", 1},
    {Quantity::velocity, "m/sec", 1},
    {Quantity::velocity, "cm/s", 1e-2},
    {Quantity::velocity, "cm/sec", 1e-2},
    {Quantity::velocity, "mm/s", 1e-3},
    {Quantity::displacement, "m", 1},
    {Quantity::displacement, "cm", 1e-2},
    {Quantity::displacement, "mm", 1e-3},
};

/// Limits that every strong-motion record meets. Damaged times and times in a wrong unit do not.
constexpr double shortest_step = 1e-6;  // s
constexpr double longest_record = 1e6;  // s

std::string known_units(Quantity quantity) {
    std::string text;
    for (const UnitRow& row : units)
        if (row.quantity == quantity) text += (text.empty() ? "" : ", ") + std::string(row.name);
    return "a unit of " + quantity_name(quantity) + ": " + text;
}

const RecordFormat& declared_format(const std::string& key, const std::string& file_name) {
    std::string known;
    for (const RecordFormat* format : record_formats()) {
        if (key == format->key) return *format;
        known += (known.empty() ? "" : ", ") + std::string(format->key);
    }
    throw InputError({file_name}, "the format '" + key + "' is not known", known);
}

const RecordFormat& recognised_format(const RecordLines& lines) {
    std::string known;
    for (const RecordFormat* format : record_formats()) {
        if (format->recognises(lines)) return *format;
        known += (known.empty() ? "" : ", ") + std::string(format->name);
    }
    if (lines.bytes().starts_with("\x1f\x8b") || lines.bytes().starts_with("PK\x03\x04"))
        throw InputError({lines.file_name()}, "is compressed", "the file that gunzip or unzip makes of it");
    const bool binary = lines.bytes().substr(0, 4096).find('\0') != std::string_view::npos;
    throw InputError({lines.file_name(), binary ? 0 : 1},
                     binary ? "is a binary file in no known record format" : "is in no known record format",
                     known);
}

}  // namespace

std::span<const RecordFormat* const> record_formats() {
    static const RecordFormat* const table[] = {
#define RECORD_FORMAT(name) &name##_format,
#include "record/record_formats.def"
#undef RECORD_FORMAT
    };
    return table;
}

std::string quantity_name(Quantity quantity) {
    switch (quantity) {
        case Quantity::velocity:
            return "velocity";
        case Quantity::displacement:
            return "displacement";
        default:
            return "acceleration";
    }
}

std::optional<Quantity> quantity_of_name(std::string_view name) {
    for (const Quantity quantity : {Quantity::acceleration, Quantity::velocity, Quantity::displacement})
        if (lower_case(name) == quantity_name(quantity)) return quantity;
    return std::nullopt;
}

std::optional<double> record_unit_factor(Quantity quantity, std::string_view unit) {
    std::string plain = lower_case(unit);
    std::erase(plain, '^');
    for (const UnitRow& row : units)
        if (row.quantity == quantity && plain == row.name) return row.factor;
    return std::nullopt;
}

void check_sampling(double dt, std::size_t count, const RecordLines& lines, std::size_t index) {
    if (dt >= shortest_step && dt * static_cast<double>(count) <= longest_record) return;
    lines.fail(index, std::to_string(count) + " samples at steps of " + shortest_text(dt) + " s",
               "times in seconds: steps of 1e-6 s or more, 1e6 s in all or less");
}

void resolve_units(Record& record, std::optional<Quantity> own_quantity, const std::string& own_unit,
                   const RecordDeclaration& declaration, const RecordLines& lines, std::size_t index) {
    const std::optional<Quantity> stated_quantity =
        declaration.quantity ? declaration.quantity : own_quantity;
    if (!stated_quantity && !declaration.assumed_quantity)
        lines.fail(index, "the quantity of the values is not given",
                   "quantity = \"acceleration\", \"velocity\" or \"displacement\" beside file = ... in the "
                   "model file");
    record.quantity = stated_quantity ? *stated_quantity : *declaration.assumed_quantity;
    if (own_quantity && *own_quantity != record.quantity)
        lines.fail(index, "the file holds " + quantity_name(*own_quantity),
                   quantity_name(record.quantity) + ", as the model file says");
    const std::string unit = own_unit.empty() ? declaration.unit : own_unit;
    if (unit.empty())
        lines.fail(index, "the unit of the values is not given",
                   "unit = \"...\" beside file = ... in the model file");
    const std::optional<double> factor = record_unit_factor(record.quantity, unit);
    if (!factor) lines.fail(index, "the unit '" + unit + "' is not known", known_units(record.quantity));
    if (!own_unit.empty() && !declaration.unit.empty() &&
        record_unit_factor(record.quantity, declaration.unit) != factor)
        lines.fail(index, "the file's unit is " + own_unit, declaration.unit + ", as the model file says");
    for (double& value : record.values) {
        value *= *factor;
        if (!is_in_allowed_range(value))
            lines.fail(index, "a value is " + shortest_text(value) + " in SI units, which is too large",
                       "a record of ground motion");
    }
}

Record parse_record(std::string_view text, const std::string& file_name,
                    const RecordDeclaration& declaration) {
    const RecordLines lines(text, file_name);
    const RecordFormat& format = declaration.format.empty() ? recognised_format(lines)
                                                            : declared_format(declaration.format, file_name);
    if (!format.stacks_channels && declaration.channel != 1)
        throw InputError({file_name},
                         "there is no channel " + std::to_string(declaration.channel) + ": a " + format.name +
                             " file holds one",
                         "no channel");
    if (&format != &run_history_format && !declaration.point.empty())
        throw InputError(
            {file_name},
            "there is no point '" + declaration.point + "': a " + format.name + " file holds no points",
            "the history.csv of a run, or no point");
    return format.read(lines, declaration);
}

std::vector<std::string> record_format_keys() {
    std::vector<std::string> keys;
    for (const RecordFormat* format : record_formats()) keys.emplace_back(format->key);
    return keys;
}

Record read_record(const std::filesystem::path& path, const RecordDeclaration& declaration) {
    return parse_record(read_text_file(path), path.string(), declaration);
}

}  // namespace rockslope::record
