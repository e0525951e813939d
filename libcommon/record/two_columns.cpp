#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"
#include "record/record_format.hpp"
#include "record/two_columns.hpp"

namespace rockslope::record {

namespace {

constexpr std::string_view separators = " \t,;";

/// Largest relative difference of a step from the mean step. Times are often written with few digits.
constexpr double step_tolerance = 1e-3;
/// Largest difference of a time from n dt over the whole record, relative to dt.
constexpr double drift_tolerance = 1e-2;

bool is_skipped(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    return start == std::string_view::npos || line[start] == '#';
}

struct Row {
    double time = 0;
    double value = 0;
};

std::optional<Row> row_of(std::string_view line) {
    const auto words = words_of(line, separators);
    if (words.size() != 2) return std::nullopt;
    const auto time = sample_number(words[0]);
    const auto value = sample_number(words[1]);
    if (!time || !value) return std::nullopt;
    return Row{*time, *value};
}

/// Whether a line is a sample, possibly an invalid one. A heading does not begin with a number, not even nan
/// or 1e999.
bool begins_with_number(std::string_view line) {
    const auto words = words_of(line, separators);
    if (words.empty()) return false;
    double value = 0;
    const char* const last = words[0].data() + words[0].size();
    return std::from_chars(words[0].data(), last, value).ptr == last;
}

std::size_t first_content(const RecordLines& lines) {
    std::size_t i = 0;
    while (i < lines.size() && is_skipped(lines[i])) ++i;
    return i;
}

/// Quantity and unit of the second column in a heading such as "time (s), acceleration (m/s2)".
RecordDeclaration parse_heading(std::string_view line) {
    RecordDeclaration heading;
    const std::size_t comma = line.find_first_of(",;\t");
    if (comma == std::string_view::npos) return heading;
    const auto words = words_of(line.substr(comma + 1), " \t,;()[]\"");
    if (!words.empty()) heading.quantity = quantity_of_name(words[0]);
    if (heading.quantity && words.size() > 1) heading.unit = std::string(words[1]);
    return heading;
}

/// A number with six digits, for messages.
std::string short_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// The mean time step. @throws InputError if the steps are not equal within the tolerances.
double uniform_step(const RecordLines& lines, const TwoColumns& columns) {
    const std::vector<double>& times = columns.times;
    const double dt = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    check_sampling(dt, times.size(), lines, columns.lines.back());
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step = times[i] - times[i - 1];
        const double uniform_time = times.front() + static_cast<double>(i) * dt;
        const bool uniform = std::abs(step - dt) <= step_tolerance * dt + 1e-9 &&
                             std::abs(times[i] - uniform_time) <= drift_tolerance * dt + 1e-9;
        if (!uniform)
            lines.fail(columns.lines[i],
                       "the time step is uneven: " + short_text(step) + " s where the mean is " +
                           short_text(dt) + " s",
                       "equal steps");
    }
    // Removes the rounding error of sums: 0.01, not 0.009999999999999998.
    const double rounded = std::round(dt * 1e9) / 1e9;
    return std::abs(rounded - dt) <= 1e-12 ? rounded : dt;
}

bool is_two_columns(const RecordLines& lines) {
    const std::size_t first = first_content(lines);
    if (first < lines.size() && begins_with_number(lines[first])) return true;
    std::size_t second = first + 1;
    while (second < lines.size() && is_skipped(lines[second])) ++second;
    return second < lines.size() && row_of(lines[second]).has_value();
}

Record read_two_columns(const RecordLines& lines, const RecordDeclaration& declaration) {
    TwoColumns columns = parse_two_columns(lines);
    Record record{uniform_step(lines, columns), std::move(columns.values), {}};
    resolve_units(record, columns.heading.quantity, columns.heading.unit, declaration, lines,
                  first_content(lines));
    return record;
}

}  // namespace

TwoColumns parse_two_columns(const RecordLines& lines) {
    TwoColumns columns;
    const std::size_t first = first_content(lines);
    const bool has_heading = first < lines.size() && !begins_with_number(lines[first]);
    if (has_heading) columns.heading = parse_heading(lines[first]);
    for (std::size_t i = first + (has_heading ? 1 : 0); i < lines.size(); ++i) {
        if (is_skipped(lines[i])) continue;
        const auto row = row_of(lines[i]);
        if (!row || !is_in_allowed_range(row->time) || !is_in_allowed_range(row->value))
            lines.fail(i, "'" + std::string(lines[i].substr(0, 60)) + "' is not a sample",
                       "two finite numbers, time and value");
        if (!columns.times.empty() && row->time <= columns.times.back())
            lines.fail(i, "the time does not increase",
                       "a time later than " + shortest_text(columns.times.back()) + " s");
        columns.times.push_back(row->time);
        columns.values.push_back(row->value);
        columns.lines.push_back(i);
    }
    if (columns.times.size() < 2)
        lines.fail(std::max<std::size_t>(lines.size(), 1) - 1, "there are fewer than two samples",
                   "lines of time and value");
    return columns;
}

const RecordFormat two_columns_format{"csv", "two columns (time, value)", false, is_two_columns,
                                      read_two_columns};

}  // namespace rockslope::record
