#include "dda/laboratory/shear_table.hpp"

#include <array>
#include <cmath>
#include <functional>

#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "common/config/config_table.hpp"
#include "common/config/units.hpp"
#include "dda/joint/shear_step.hpp"

namespace rockslope::dda {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\"");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t start = 0; start <= line.size();) {
        const std::size_t end = std::min(line.find_first_of(",;", start), line.size());
        fields.push_back(trimmed(line.substr(start, end - start)));
        start = end + 1;
    }
    return fields;
}

/// A column to be read: its index in the row, its destination and its factor to SI.
struct Column {
    std::size_t field = 0;
    std::vector<double>* values = nullptr;
    double factor = 1;
};

struct Quantity {
    std::string_view name;
    Dimension dimension;
    std::vector<double> ShearTable::*values;
};
constexpr std::array<Quantity, 4> quantities = {{
    {"displacement", Dimension::length, &ShearTable::displacement},
    {"shear stress", Dimension::stress, &ShearTable::shear_stress},
    {"dilation", Dimension::length, &ShearTable::dilation},
    {"normal stress", Dimension::stress, &ShearTable::normal_stress},
}};

/// The stresses of a measured joint are compared over the length that bears them, as in a laboratory.
std::string_view without_length(std::string_view name) {
    constexpr std::string_view ending = " over bearing length";
    if (name.ends_with(ending)) name.remove_suffix(ending.size());
    return name;
}

/// Reads the heading of a table. @param prefix columns whose names do not begin with it are skipped.
std::vector<Column> read_heading(std::string_view line, const SourceLocation& place, std::string_view prefix,
                                 ShearTable& table) {
    std::vector<Column> columns;
    const std::vector<std::string_view> fields = fields_of(line);
    bool has_displacement = false;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (!fields[k].starts_with(prefix)) continue;
        const std::string_view field = fields[k].substr(prefix.size());
        const std::size_t bracket = field.find('(');
        const std::string_view name = without_length(trimmed(field.substr(0, bracket)));
        for (const Quantity& quantity : quantities) {
            if (name != quantity.name) continue;
            const std::size_t close = field.find(')');
            if (bracket == std::string_view::npos || close == std::string_view::npos || close < bracket)
                throw InputError(place, "column '" + std::string(name) + "' has no unit",
                                 "one in brackets, such as \"" + std::string(name) +
                                     (quantity.dimension == Dimension::length ? " (mm)\"" : " (MPa)\""));
            const std::string_view unit = trimmed(field.substr(bracket + 1, close - bracket - 1));
            const auto factor = unit_factor(quantity.dimension, unit);
            if (!factor)
                throw InputError(place,
                                 "column '" + std::string(name) + "' is in '" + std::string(unit) + "'",
                                 describe(quantity.dimension));
            for (const Column& other : columns)
                if (other.values == &(table.*quantity.values))
                    throw InputError(place, "there are two columns '" + std::string(name) + "'", "one");
            columns.push_back({k, &(table.*quantity.values), *factor});
            has_displacement = has_displacement || quantity.values == &ShearTable::displacement;
        }
    }
    if (!has_displacement)
        throw InputError(place, "there is no column '" + std::string(prefix) + "displacement'",
                         "a heading such as \"displacement (mm),shear stress (MPa),dilation (mm)\"");
    return columns;
}

constexpr double largest_number = 1e30;

void read_row(std::string_view line, const SourceLocation& place, const std::vector<Column>& columns) {
    const std::vector<std::string_view> fields = fields_of(line);
    for (const Column& column : columns) {
        const std::string text(column.field < fields.size() ? fields[column.field] : std::string_view{});
        const auto value = parse_number(text);
        if (!value || std::abs(*value) > largest_number)
            throw InputError(
                place,
                "'" + text + "' in column " + std::to_string(column.field + 1) + " is not a finite number",
                "a number below 1e30");
        column.values->push_back(*value * column.factor);
    }
}

std::optional<Misfit> misfit(const std::vector<ShearTestRow>& rows, const std::vector<double>& measured,
                             double ShearTestRow::*computed) {
    if (measured.empty()) return std::nullopt;
    Misfit result;
    double sum = 0;
    for (std::size_t k = 0; k < measured.size(); ++k) {
        const double difference = std::abs(rows[k].*computed - measured[k]);
        sum += difference * difference;
        if (difference > result.largest) {
            result.largest = difference;
            result.at = rows[k].displacement;
        }
    }
    result.root_mean_square = std::sqrt(sum / static_cast<double>(measured.size()));
    return result;
}

/// Calls visit(line, place) for every line that is neither empty nor a comment.
template <class Visit>
void for_each_line(const std::string& text, const std::filesystem::path& file, const Visit& visit) {
    int number = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(start, end - start));
        start = end + 1;
        ++number;
        if (!line.empty() && line.front() != '#') visit(line, SourceLocation{file.string(), number});
    }
}

ShearTable checked(ShearTable table, const std::filesystem::path& file) {
    if (table.displacement.empty())
        throw InputError({file.string()}, "has no data rows", "a heading and at least one row");
    return table;
}

}  // namespace

ShearTable read_shear_table(const std::filesystem::path& file) {
    ShearTable table;
    std::vector<Column> columns;
    for_each_line(read_text_file(file), file, [&](std::string_view line, const auto& place) {
        if (columns.empty())
            columns = read_heading(line, place, "", table);
        else
            read_row(line, place, columns);
    });
    return checked(std::move(table), file);
}

ShearTable read_measured_joint(const std::filesystem::path& file, const std::string& joint) {
    ShearTable table;
    std::vector<Column> columns;
    std::string time;
    for_each_line(read_text_file(file), file, [&](std::string_view line, const auto& place) {
        if (columns.empty()) {
            columns = read_heading(line, place, joint + " ", table);
            return;
        }
        const std::string now(fields_of(line).front());
        if (now == time)
            for (const Column& column : columns) column.values->clear();
        time = now;
        read_row(line, place, columns);
    });
    return checked(std::move(table), file);
}

std::string shear_rows_csv(const std::vector<ShearTestRow>& rows) {
    std::string text =
        "displacement (m),shear stress (Pa),normal stress (Pa),dilation (m),slip (m),state,stage,"
        "mobilised ratio,reversals,cycle,work (J/m2)\n";
    for (const ShearTestRow& row : rows) {
        for (const double value :
             {row.displacement, row.shear_stress, row.normal_stress, row.dilation, row.slip})
            text += shortest_text(value) + ',';
        text += std::string(row.normal_stress > 0 ? row.sliding ? "sliding" : "locked" : "open") + ',' +
                stage_name(row.record.stage) + ',' + shortest_text(row.record.mobilised_ratio) + ',' +
                std::to_string(row.record.reversals) + ',' + std::to_string(row.record.cycle) + ',' +
                shortest_text(row.work) + '\n';
    }
    return text;
}

Comparison compare(ShearTest test, const ShearTable& measured) {
    Comparison comparison;
    test.path = measured.displacement;
    if (test.boundary == NormalBoundary::prescribed_stress) test.path_stress = measured.normal_stress;
    comparison.rows = shear_test_at_path_points(test);
    comparison.shear_stress = misfit(comparison.rows, measured.shear_stress, &ShearTestRow::shear_stress);
    comparison.dilation = misfit(comparison.rows, measured.dilation, &ShearTestRow::dilation);
    comparison.normal_stress = misfit(comparison.rows, measured.normal_stress, &ShearTestRow::normal_stress);
    return comparison;
}

}  // namespace rockslope::dda
