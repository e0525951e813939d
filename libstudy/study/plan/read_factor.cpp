#include "study/plan/read_factor.hpp"

#include <glob.h>

#include <algorithm>
#include <cmath>

#include "blockgen/input/read_distribution.hpp"
#include "common/base/text.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

constexpr int most_values = 1'000'000;  ///< of one factor

std::vector<std::string> names_of(const std::vector<Factor>& factors) {
    std::vector<std::string> names;
    for (const Factor& factor : factors) names.push_back(factor.name);
    return names;
}

/// The factor that a key names. @throws InputError with the name that is nearest.
const Factor& factor_named(const ConfigTable& table, const char* key, const std::vector<Factor>& before) {
    const std::string name = table.string(key);
    for (const Factor& factor : before)
        if (factor.name == name) return factor;
    const auto nearest = nearest_word(name, names_of(before));
    table.fail(key, "there is no factor '" + name + "' before this one",
               nearest ? "perhaps '" + *nearest + "'" : "the name of an earlier [[factor]]");
}

Target target_of(const ConfigTable& table, const char* where, const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string file = text.substr(0, colon);
    if (colon == std::string::npos || colon + 1 == text.size() || (file != "slope" && file != "run"))
        table.fail(where, "'" + text + "' names no key",
                   "slope:KEY or run:KEY, with the path of --set, e.g. \"run:stage[1].step\"");
    return {file == "slope" ? ModelFile::slope : ModelFile::run, text.substr(colon + 1)};
}

std::vector<Target> read_targets(const ConfigTable& table) {
    std::vector<Target> targets;
    if (table.has("keys")) {
        for (const std::string& text : table.strings("keys"))
            targets.push_back(target_of(table, "keys", text));
        if (targets.empty()) table.fail("keys", "'keys' is empty", "one key or more");
        return targets;
    }
    return {target_of(table, "key", table.string("key"))};
}

/// A number as TOML: whole where the range is, and with its unit as a string.
std::string number_text(double value, bool is_whole, const std::string& unit) {
    std::string text = is_whole ? std::to_string(std::llround(value)) : shortest_text(value);
    if (!unit.empty()) return "\"" + text + " " + unit + "\"";
    if (!is_whole && text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

bool is_whole(double value) {
    return value == std::floor(value) && std::abs(value) < 1e15;
}

void read_range(const ConfigTable& range, Factor& factor) {
    const double from = range.number("from"), to = range.number("to");
    if (!(from <= to)) range.fail("to", "'to' is below 'from'", "to >= from");
    if (!range.has("step") && !range.has("count")) {
        const bool is_of_numbers =
            is_whole(from) && is_whole(to) && factor.unit.empty() && !range.has("continuous");
        const bool continuous = range.boolean("continuous", false);
        if (is_of_numbers || !continuous) {
            if (!is_whole(to - from) || to - from >= most_values)
                range.fail("to", "the range has no 'step'", "'step' or 'count', or continuous = true");
            for (long k = 0; k <= std::lround(to - from); ++k)
                factor.values.push_back(
                    number_text(from + static_cast<double>(k), is_whole(from), factor.unit));
        } else {
            factor.distribution = blockgen::Distribution{blockgen::Law::uniform, 0, 0, from, to, 1};
        }
        range.finish();
        return;
    }
    const std::int64_t count =
        range.has("count")
            ? range.integer("count")
            : std::llround(std::floor((to - from) / range.checked(
                                                        "step", range.number("step"),
                                                        [](double v) { return v > 0; }, "a positive number") +
                                      1e-9)) +
                  1;
    range.checked(
        range.has("count") ? "count" : "step", static_cast<double>(count),
        [](double v) { return v >= 1 && v <= most_values; }, "1 to 1000000 values");
    const double step = range.has("count") ? (count > 1 ? (to - from) / static_cast<double>(count - 1) : 0)
                                           : range.number("step");
    const bool whole = is_whole(from) && is_whole(step);
    for (std::int64_t k = 0; k < count; ++k)
        factor.values.push_back(number_text(from + static_cast<double>(k) * step, whole, factor.unit));
    range.finish();
}

/// The files that a pattern matches, sorted.
std::vector<fs::path> matching(const fs::path& pattern) {
    glob_t found{};
    std::vector<fs::path> files;
    if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
        for (std::size_t k = 0; k < found.gl_pathc; ++k) files.emplace_back(found.gl_pathv[k]);
    ::globfree(&found);
    return files;
}

void read_files(const ConfigTable& table, const fs::path& folder, Factor& factor) {
    const std::vector<std::string> patterns =
        table.is_string("files") ? std::vector{table.string("files")} : table.strings("files");
    for (const std::string& pattern : patterns) {
        const std::vector<fs::path> files = matching(folder / pattern);
        if (files.empty()) table.fail("files", "no file matches '" + pattern + "'", "files that exist");
        for (const fs::path& file : files) factor.files.push_back(file.lexically_normal());
    }
    for (const fs::path& file : factor.files) factor.values.push_back(file.filename().string());
}

Dimension dimension_of(const RecordScale& scale) {
    const bool is_velocity =
        scale.measure == ScaleMeasure::peak_velocity || scale.measure == ScaleMeasure::arias_intensity;
    return is_velocity ? Dimension::velocity : Dimension::acceleration;
}

void read_scale(const ConfigTable& table, const std::vector<Factor>& before, Factor& factor) {
    const std::string name = table.string("scale");
    factor.scale = scale_of_name(name);
    if (!factor.scale)
        table.fail("scale", "'" + name + "' is no intensity measure",
                   "\"PGA\", \"PGV\", \"Arias\" or \"Sa(T)\", T in s");
    const Factor& record = factor_named(table, "record", before);
    if (record.files.empty())
        table.fail("record", "the factor '" + record.name + "' has no files",
                   "a factor whose values are records");
    factor.scale->record = record.name;
    for (Target target : record.targets) {
        const std::string end = ".file";
        if (!target.key.ends_with(end))
            table.fail("record", "the key '" + target.key + "' is no record", "a key that ends in .file");
        target.key.replace(target.key.size() - end.size(), end.size(), ".scale");
        factor.targets.push_back(target);
    }
    factor.intensities = table.numbers("values", dimension_of(*factor.scale));
    for (const double value : factor.intensities) {
        table.checked(
            "values", value, [](double v) { return v > 0; }, "positive intensities");
        factor.values.push_back(shortest_text(value));
    }
}

}  // namespace

std::optional<RecordScale> scale_of_name(const std::string& name) {
    if (name == "PGA") return RecordScale{ScaleMeasure::peak_acceleration, 0, {}};
    if (name == "PGV") return RecordScale{ScaleMeasure::peak_velocity, 0, {}};
    if (name == "Arias") return RecordScale{ScaleMeasure::arias_intensity, 0, {}};
    if (!name.starts_with("Sa(") || !name.ends_with(")")) return std::nullopt;
    const auto period = parse_number(std::string_view(name).substr(3, name.size() - 4));
    if (!period || !(*period > 0)) return std::nullopt;
    return RecordScale{ScaleMeasure::spectral_acceleration, *period, {}};
}

Factor read_factor(const ConfigTable& table, const std::vector<Factor>& before, const fs::path& folder) {
    Factor factor;
    factor.name = table.string("name");
    const std::vector<std::string> known = names_of(before);
    if (factor.name.empty() || std::find(known.begin(), known.end(), factor.name) != known.end())
        table.fail("name", "there are two factors '" + factor.name + "'", "names that differ");
    if (table.has("pair")) {
        factor.paired_with = factor_named(table, "pair", before).name;
        for (const Factor& other : before)
            if (other.name == factor.paired_with && !other.paired_with.empty())
                factor.paired_with = other.paired_with;
    }
    if (table.has("scale")) {
        read_scale(table, before, factor);
    } else {
        factor.targets = read_targets(table);
        factor.unit = table.string("unit", "");
        int given = 0;
        for (const char* key : {"values", "range", "files", "distribution"}) given += table.has(key) ? 1 : 0;
        if (given != 1)
            table.fail("values",
                       "[" + table.path() + "] has " + (given == 0 ? "no values" : "several kinds of values"),
                       "one of 'values', 'range', 'files', 'distribution'");
        if (table.has("values")) factor.values = table.value_texts("values");
        if (table.has("range")) read_range(table.table("range"), factor);
        if (table.has("files")) read_files(table, folder, factor);
        if (table.has("distribution"))
            factor.distribution = blockgen::read_distribution(table, "distribution", Dimension::none);
    }
    if (factor.values.empty() && !factor.distribution)
        table.fail("values", "the factor '" + factor.name + "' has no value", "one value or more");
    return factor;
}

}  // namespace rockslope::study
