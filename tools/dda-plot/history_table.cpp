#include "history_table.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "record/record_lines.hpp"

namespace rockslope {

namespace {

const std::string displacement_suffix = " ux (m)";

}  // namespace

std::size_t HistoryTable::column(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::out_of_range("history.csv has no column '" + name + "'");
    return found - names.begin();
}

std::vector<std::string> HistoryTable::points() const {
    std::vector<std::string> points;
    for (const std::string& name : names)
        if (name.ends_with(displacement_suffix))
            points.push_back(name.substr(0, name.size() - displacement_suffix.size()));
    return points;
}

HistoryTable without_reset_stages(const HistoryTable& history) {
    std::size_t first = 0;
    for (std::size_t row = 0; row + 1 < history.time.size(); ++row) {
        const bool ends = history.stage[row] != history.stage[row + 1];
        const bool same_instant = history.time[row] == history.time[row + 1];
        const auto at_zero = [&](const std::string& point) {
            return history.columns[history.column(point + " ux (m)")][row + 1] == 0 &&
                   history.columns[history.column(point + " uy (m)")][row + 1] == 0;
        };
        const std::vector<std::string> points = history.points();
        if (ends && same_instant && std::all_of(points.begin(), points.end(), at_zero)) first = row + 1;
    }
    HistoryTable kept = history;
    const auto cut = [first](auto& values) {
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
    };
    cut(kept.time);
    cut(kept.stage);
    for (auto& column : kept.columns) cut(column);
    return kept;
}

HistoryTable read_history(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    HistoryTable table;
    int line_number = 0;
    std::size_t start = 0;
    for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
        const std::vector<std::string> fields =
            record::csv_fields(std::string_view(text).substr(start, end - start));
        if (++line_number == 1) {
            if (fields.size() < 2)
                throw InputError({path.string(), 1}, "is not a history", "the history.csv of a run");
            table.names.assign(fields.begin() + 2, fields.end());
            table.columns.resize(table.names.size());
            continue;
        }
        const auto time = parse_number(fields.front());
        if (fields.size() != table.names.size() + 2 || !time)
            throw InputError({path.string(), line_number}, "has " + std::to_string(fields.size()) + " fields",
                             std::to_string(table.names.size() + 2) + ", the first a time");
        table.time.push_back(*time);
        table.stage.push_back(fields[1]);
        for (std::size_t i = 0; i < table.names.size(); ++i) {
            const auto value = parse_number(fields[i + 2]);
            if (!value)
                throw InputError({path.string(), line_number}, "'" + fields[i + 2] + "' is not a number",
                                 "a finite number");
            table.columns[i].push_back(*value);
        }
    }
    if (table.time.empty()) throw InputError({path.string()}, "contains no rows yet", "a run that has begun");
    for (const std::string& point : table.points())
        if (std::find(table.names.begin(), table.names.end(), point + " uy (m)") == table.names.end())
            throw InputError({path.string(), 1}, "there is no column '" + point + " uy (m)'",
                             "the history.csv of a run");
    return table;
}

}  // namespace rockslope
