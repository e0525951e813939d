#include "joint_history.hpp"

#include <algorithm>
#include <limits>

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "record/record_lines.hpp"

namespace rockslope {

namespace {
using record::csv_fields;

const std::string joint_suffix = " displacement (m)";

struct Column {
    std::vector<double>* values;
    std::size_t field;
};

std::vector<std::string> heading_of(const std::filesystem::path& table, const std::string& text) {
    std::vector<std::string> heading = csv_fields(std::string_view(text).substr(0, text.find('\n')));
    if (heading.front() != "time (s)")
        throw InputError({table.string(), 1}, "the first column is not 'time (s)'",
                         "the joints.csv of a run");
    return heading;
}

std::vector<Column> columns_of(JointHistory& history, const std::vector<std::string>& heading,
                               const std::string& prefix, const SourceLocation& place) {
    std::vector<Column> columns = {{&history.time, 0}};
    const auto find = [&](const char* quantity, std::vector<double>& values) {
        const auto found = std::find(heading.begin(), heading.end(), prefix + quantity);
        if (found == heading.end()) return false;
        columns.push_back({&values, static_cast<std::size_t>(found - heading.begin())});
        return true;
    };
    if (!find("displacement (m)", history.displacement))
        throw InputError(place, "there is no column '" + prefix + "displacement (m)'",
                         prefix.empty() ? "a table of time and displacement" : "a [[measured_joint]]'s name");
    find("dilation (m)", history.dilation);
    find("shear stress over bearing length (Pa)", history.shear_stress);
    find("normal stress over bearing length (Pa)", history.normal_stress);
    find("strength (Pa)", history.strength);
    find("reversals", history.reversals);
    return columns;
}

}  // namespace

std::vector<std::string> measured_joints(const std::filesystem::path& table) {
    std::vector<std::string> joints;
    for (const std::string& name : heading_of(table, read_text_file(table)))
        if (name.ends_with(joint_suffix)) joints.push_back(name.substr(0, name.size() - joint_suffix.size()));
    return joints;
}

JointHistory read_joint_history(const std::filesystem::path& table, const std::string& joint,
                                std::string label) {
    const std::string text = read_text_file(table);
    JointHistory history;
    history.label = std::move(label);
    const std::vector<std::string> heading = heading_of(table, text);
    const std::vector<Column> columns =
        columns_of(history, heading, joint.empty() ? "" : joint + " ", {table.string(), 1});
    int line_number = 1;
    double last_time = std::numeric_limits<double>::quiet_NaN();
    std::size_t start = text.find('\n') + 1;
    for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
        const std::vector<std::string> fields = csv_fields(std::string_view(text).substr(start, end - start));
        const SourceLocation place{table.string(), ++line_number};
        if (fields.size() != heading.size())
            throw InputError(place, "has " + std::to_string(fields.size()) + " fields",
                             std::to_string(heading.size()));
        std::vector<double> numbers;
        for (const Column& column : columns) {
            const auto value = parse_number(fields[column.field]);
            if (!value)
                throw InputError(place, "'" + fields[column.field] + "' is not a number", "a finite number");
            numbers.push_back(*value);
        }
        // A reset of the displacements writes a second row at the same time.
        const bool is_reset = numbers.front() == last_time;
        last_time = numbers.front();
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (is_reset) columns[k].values->clear();
            columns[k].values->push_back(numbers[k]);
        }
    }
    if (history.time.empty())
        throw InputError({table.string()}, "contains no rows yet", "a run that has begun");
    if (!joint.empty()) {
        const double first = history.time.front();
        for (double& time : history.time) time -= first;
    }
    return history;
}

}  // namespace rockslope
