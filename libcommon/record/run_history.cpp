#include <algorithm>
#include <array>
#include <cmath>

#include "common/base/text.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

constexpr std::string_view first_columns = "time (s),stage,";
constexpr std::string_view prescribed = "prescribed ";

/// Letter and unit of a quantity in column headings such as "crest ux (m)".
struct Column {
    char letter;
    const char* unit;
};
Column column_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::velocity:
            return {'v', "m/s"};
        case Quantity::displacement:
            return {'u', "m"};
        default:
            return {'a', "m/s2"};
    }
}

/// "crest x" for each column "crest ax (m/s2)".
std::vector<std::string> points_of(const std::vector<std::string>& headings) {
    std::vector<std::string> points;
    for (const std::string& heading : headings)
        for (const char direction : {'x', 'y'}) {
            const std::string end = std::string(" a") + direction + " (m/s2)";
            if (heading.ends_with(end))
                points.push_back(heading.substr(0, heading.size() - end.size()) + " " + direction);
        }
    return points;
}

/// The column of a point and direction. "base x" also finds the column of "prescribed base".
std::size_t find_column(const RecordLines& lines, const RecordDeclaration& declaration, Quantity quantity) {
    const std::vector<std::string> headings = csv_fields(lines[0]);
    const std::string& point = declaration.point;
    const Column column = column_of(quantity);
    if (point.size() > 2) {
        std::string name =
            point.substr(0, point.size() - 1) + column.letter + point.back() + " (" + column.unit + ")";
        for (const std::string& heading : {name, std::string(prescribed) + name}) {
            const auto found = std::find(headings.begin(), headings.end(), heading);
            if (found != headings.end()) return found - headings.begin();
        }
    }
    std::string known;
    for (const std::string& name : points_of(headings)) known += (known.empty() ? "'" : ", '") + name + "'";
    lines.fail(0, point.empty() ? "no point is given" : "there is no point '" + point + "'",
               "point = " + (known.empty() ? "\"...\"" : "one of " + known));
}

struct Samples {
    std::vector<double> times, values;
    std::vector<std::size_t> lines;
};

/// The times and values of a column in the rows of the last stage.
Samples last_stage(const RecordLines& lines, std::size_t column) {
    Samples samples;
    const std::size_t count = csv_fields(lines[0]).size();
    std::string stage;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (trimmed(lines[i]).empty()) continue;
        const std::vector<std::string> fields = csv_fields(lines[i]);
        if (fields.size() != count)
            lines.fail(i, "has " + std::to_string(fields.size()) + " fields",
                       std::to_string(count) + ", as the first line");
        const auto time = parse_number(fields[0]), value = parse_number(fields[column]);
        if (!time || !value)
            lines.fail(i, "'" + fields[time ? column : 0] + "' is not a finite number",
                       "the history of a run");
        if (fields[1] != stage) samples = {};
        stage = fields[1];
        if (!samples.times.empty() && !(*time > samples.times.back()))
            lines.fail(i, "the time does not increase", "the history of a run");
        samples.times.push_back(*time);
        samples.values.push_back(*value);
        samples.lines.push_back(i);
    }
    if (samples.times.size() < 2)
        lines.fail(lines.size() - 1, "the last stage has fewer than two rows", "a run that has begun");
    return samples;
}

/// The samples interpolated at as many equal steps. Rows of a history are uneven where time steps were cut.
Record at_uniform_steps(const Samples& samples) {
    const std::size_t count = samples.times.size();
    Record record;
    record.dt = (samples.times.back() - samples.times.front()) / static_cast<double>(count - 1);
    std::size_t k = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double time = samples.times.front() + static_cast<double>(i) * record.dt;
        while (k + 2 < count && samples.times[k + 1] < time) ++k;
        const double fraction = (time - samples.times[k]) / (samples.times[k + 1] - samples.times[k]);
        record.values.push_back(
            std::lerp(samples.values[k], samples.values[k + 1], std::clamp(fraction, 0.0, 1.0)));
    }
    return record;
}

bool is_run_history(const RecordLines& lines) {
    return lines.size() > 0 && lines[0].starts_with(first_columns);
}

Record read_run_history(const RecordLines& lines, const RecordDeclaration& declaration) {
    if (!is_run_history(lines))
        lines.fail(0, "there is no heading of a run's history", "'" + std::string(first_columns) + "...'");
    const Quantity quantity = declaration.quantity.value_or(Quantity::acceleration);
    const Samples samples = last_stage(lines, find_column(lines, declaration, quantity));
    Record record = at_uniform_steps(samples);
    check_sampling(record.dt, record.values.size(), lines, samples.lines.front());
    resolve_units(record, quantity, column_of(quantity).unit, declaration, lines, 0);
    return record;
}

}  // namespace

const RecordFormat run_history_format{"run", "history of a run", false, is_run_history, read_run_history};

}  // namespace rockslope::record
