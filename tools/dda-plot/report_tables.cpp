#include "report_tables.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "history_table.hpp"
#include "record/record_lines.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope {

namespace {

namespace fs = std::filesystem;
using PageJson = nlohmann::json;

/// Values of a curve, and blocks of a table, that a page keeps.
constexpr std::size_t most_samples = 1500, most_rows = 30;
constexpr double damping = 0.05;

/// A table of text: the heading, and the rows.
struct TextTable {
    std::vector<std::string> heading;
    std::vector<std::vector<std::string>> rows;

    std::optional<std::size_t> column(const std::string& name) const {
        const auto found = std::find(heading.begin(), heading.end(), name);
        if (found == heading.end()) return std::nullopt;
        return static_cast<std::size_t>(found - heading.begin());
    }
};

TextTable read_table(const fs::path& path) {
    const std::string text = read_text_file(path);
    TextTable table;
    std::size_t start = 0;
    for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
        std::vector<std::string> fields =
            record::csv_fields(std::string_view(text).substr(start, end - start));
        if (table.heading.empty())
            table.heading = std::move(fields);
        else if (fields.size() == table.heading.size())
            table.rows.push_back(std::move(fields));
    }
    return table;
}

/// A number with six digits, which is enough for a curve.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return parse_number(text).value_or(0);
}

PageJson thinned(const std::vector<double>& values) {
    const std::size_t stride = (values.size() + most_samples - 1) / most_samples;
    PageJson list = PageJson::array();
    for (std::size_t i = 0; i < values.size(); i += std::max<std::size_t>(stride, 1))
        list.push_back(rounded(values[i]));
    return list;
}

std::string base_of(const HistoryTable& history) {
    for (const std::string& point : history.points())
        if (point.starts_with(prescribed_prefix)) return point;
    return {};
}

PageJson history_json(const HistoryTable& history) {
    const std::string base = base_of(history);
    const auto relative = [&](const std::string& point, const std::string& direction) {
        const std::string ending = " u" + direction + " (m)";
        std::vector<double> values = history.columns[history.column(point + ending)];
        if (!base.empty())
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] -= history.columns[history.column(base + ending)][i];
        return values;
    };
    PageJson points = PageJson::array();
    for (const std::string& point : history.points())
        if (!point.starts_with(prescribed_prefix))
            points.push_back({{"name", point},
                              {"x", thinned(relative(point, "x"))},
                              {"y", thinned(relative(point, "y"))}});
    return {{"time", thinned(history.time)},
            {"stage", history.stage.front() == history.stage.back() ? history.stage.front() : ""},
            {"points", points},
            {"relative", !base.empty()}};
}

/// The acceleration of the base at equal steps, as long as the history; nothing where it does not move.
std::optional<record::Accelerogram> base_acceleration(const HistoryTable& history,
                                                      const std::string& direction) {
    const std::string base = base_of(history);
    const auto& names = history.names;
    const auto found = std::find(names.begin(), names.end(), base + " a" + direction + " (m/s2)");
    if (base.empty() || found == names.end() || history.time.size() < 3) return std::nullopt;
    const std::vector<double>& values = history.columns[static_cast<std::size_t>(found - names.begin())];
    if (std::all_of(values.begin(), values.end(), [](double a) { return a == 0; })) return std::nullopt;
    const double duration = history.time.back() - history.time.front();
    record::Accelerogram motion;
    motion.step = duration / static_cast<double>(history.time.size() - 1);
    std::size_t row = 0;
    for (std::size_t k = 0; k < history.time.size(); ++k) {
        const double time = history.time.front() + static_cast<double>(k) * motion.step;
        while (row + 2 < history.time.size() && history.time[row + 1] <= time) ++row;
        const double span = history.time[row + 1] - history.time[row];
        const double part = span > 0 ? std::clamp((time - history.time[row]) / span, 0.0, 1.0) : 1.0;
        motion.values.push_back((1 - part) * values[row] + part * values[row + 1]);
    }
    return motion;
}

PageJson base_json(const HistoryTable& history) {
    constexpr double shortest = 0.05, longest = 4;
    constexpr int periods = 60;
    std::vector<double> period(periods);
    for (int k = 0; k < periods; ++k)
        period[static_cast<std::size_t>(k)] =
            shortest * std::pow(longest / shortest, k / double{periods - 1});
    PageJson json;
    for (const char* direction : {"x", "y"}) {
        const auto motion = base_acceleration(history, direction);
        if (!motion) continue;
        PageJson spectrum = PageJson::array();
        for (const auto& ordinate : record::response_spectrum(*motion, period, damping))
            spectrum.push_back(rounded(ordinate.absolute_acceleration));
        json[direction] = {{"acceleration", thinned(motion->values)}, {"spectrum", spectrum}};
    }
    if (json.is_null()) return json;
    json["period"] = thinned(period);
    json["time"] = thinned(history.time);
    return json;
}

/// The blocks that moved most, with the columns of blocks.csv that a reader wants.
PageJson blocks_json(const TextTable& table) {
    const auto relative = table.column("relative displacement x (m)");
    const auto x = relative ? relative : table.column("displacement x (m)");
    if (!x) return {};
    const auto distance = [&](const std::vector<std::string>& row) {
        return std::hypot(parse_number(row[*x]).value_or(0), parse_number(row[*x + 1]).value_or(0));
    };
    std::vector<std::size_t> order(table.rows.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const std::size_t kept = std::min(order.size(), most_rows);
    std::partial_sort(
        order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
        [&](std::size_t a, std::size_t b) { return distance(table.rows[a]) > distance(table.rows[b]); });
    PageJson rows = PageJson::array();
    for (std::size_t i = 0; i < kept; ++i) {
        const std::vector<std::string>& row = table.rows[order[i]];
        PageJson entry = {{"distance", rounded(distance(row))}};
        for (const char* name : {"block", "material", "first slip (s of shaking)", "slipped on block",
                                 "joint material", "rotation (rad)", "Newmark slip (m)"})
            if (const auto column = table.column(name)) entry[name] = row[*column];
        rows.push_back(entry);
    }
    return rows;
}

/// The largest penetration of the steps of the last stage, m.
PageJson penetration_json(const TextTable& steps) {
    const auto column = steps.column("largest penetration (m)"), stage = steps.column("stage");
    if (!column || !stage || steps.rows.empty()) return {};
    double largest = 0;
    for (const auto& row : steps.rows)
        if (row[*stage] == steps.rows.back()[*stage])
            largest = std::max(largest, parse_number(row[*column]).value_or(0));
    return largest;
}

}  // namespace

PageJson report_tables(const fs::path& folder) {
    PageJson json;
    if (fs::exists(folder / "history.csv")) {
        const HistoryTable history = without_reset_stages(read_history(folder / "history.csv"));
        json["history"] = history_json(history);
        json["base_motion"] = base_json(history);
    }
    if (fs::exists(folder / "blocks.csv")) json["moved"] = blocks_json(read_table(folder / "blocks.csv"));
    if (fs::exists(folder / "steps.csv"))
        json["penetration"] = penetration_json(read_table(folder / "steps.csv"));
    if (fs::exists(folder / "run.toml")) json["model"] = read_text_file(folder / "run.toml");
    if (fs::exists(folder / "summary.json")) {
        json["summary"] = PageJson::parse(read_text_file(folder / "summary.json"), nullptr, false);
        if (json["summary"].is_discarded())
            throw InputError({(folder / "summary.json").string()}, "is not a summary of dda-run",
                             "summary.json as the run wrote it");
    }
    return json;
}

}  // namespace rockslope
