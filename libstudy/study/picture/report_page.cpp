#include "study/picture/report_page.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "common/base/base64.hpp"
#include "common/base/text.hpp"
#include "study/picture/fragility_picture.hpp"

namespace rockslope::study {

namespace {

const char* const style =
    "body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}td,th{border-bottom:1px solid #ccc;padding:.25em "
    ".8em;text-align:left}"
    "td.n{text-align:right}img{max-width:100%}pre{background:#f4f4f4;padding:.8em;white-space:pre-wrap}";

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string image(const Canvas& canvas, const std::string& description) {
    return "<p><img alt=\"" + xml_escaped(description) + "\" src=\"data:image/svg+xml;base64," +
           base64(canvas.bytes(PictureFormat::svg)) + "\"></p>\n";
}

std::string html_table(const TextTable& table) {
    std::string text = "<table><tr>";
    for (const std::string& heading : table.heading) text += "<th>" + xml_escaped(heading) + "</th>";
    text += "</tr>\n";
    for (const auto& row : table.rows) {
        text += "<tr>";
        for (const std::string& field : row) {
            const auto number = parse_number(field);
            text += number ? "<td class=\"n\">" + rounded(*number) + "</td>"
                           : "<td>" + xml_escaped(field) + "</td>";
        }
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

TextTable counts_table(const StudyRows& rows) {
    std::map<std::string, std::size_t> counts;
    for (const RowResult& result : rows.results)
        ++counts[state_name(result.state) + (result.cause.empty() ? "" : ": " + result.cause)];
    TextTable table{{"state", "rows"}, {}};
    for (const auto& [state, count] : counts) table.rows.push_back({state, std::to_string(count)});
    return table;
}

TextTable factors_table(const Plan& plan) {
    TextTable table{{"factor", "sets", "values"}, {}};
    for (const Factor& factor : plan.factors) {
        std::string targets;
        for (const Target& target : factor.targets)
            targets += (targets.empty() ? "" : ", ") +
                       std::string(target.file == ModelFile::slope ? "slope:" : "run:") + target.key;
        std::string values;
        for (const std::string& value : factor.values) values += (values.empty() ? "" : ", ") + value;
        if (values.size() > 200)
            values = std::to_string(factor.values.size()) + " values, " + factor.values.front() + " to " +
                     factor.values.back();
        table.rows.push_back({factor.name, targets, factor.distribution ? "a distribution" : values});
    }
    return table;
}

/// Quantiles of each measure over the rows that are done.
TextTable measures_table(const StudyRows& rows) {
    TextTable table{{"measure", "rows", "smallest", "16 %", "median", "84 %", "largest"}, {}};
    for (std::size_t k = 0; k < rows.plan.measures.size(); ++k) {
        std::vector<double> values;
        for (const RowResult& result : rows.results)
            if (result.measures[k]) values.push_back(*result.measures[k]);
        std::vector<std::string> line = {measure_heading(rows.plan.measures[k]),
                                         std::to_string(values.size())};
        std::sort(values.begin(), values.end());
        for (const double share : {0.0, 0.16, 0.5, 0.84, 1.0}) {
            const long place =
                values.empty() ? 0 : std::lround(share * static_cast<double>(values.size() - 1));
            line.push_back(values.empty() ? "" : shortest_text(values[static_cast<std::size_t>(place)]));
        }
        table.rows.push_back(std::move(line));
    }
    return table;
}

std::string curves(const StudyRows& rows) {
    std::string text;
    const TextTable table = results_table(rows);
    for (const FragilityPlan& wanted : rows.plan.fragilities) {
        FragilityRequest request;
        request.measure = wanted.measure;
        request.intensity = wanted.intensity;
        request.limit = wanted.limit;
        request.method = wanted.by_demands ? FragilityMethod::demands : FragilityMethod::outcomes;
        request.groups = fragility_groups(rows.plan);
        const Fragility fragility = fit_fragility(table, "the results", request);
        text += "<pre>" + xml_escaped(fragility_text(fragility)) + "</pre>\n" +
                image(draw_fragility(fragility), "fragility of " + wanted.measure);
        if (!fragility.groupings.empty())
            text +=
                image(draw_convergence(fragility, convergence_table(fragility)), "the median and its band");
    }
    return text;
}

bool tells_sensitivity(const Design& design) {
    return design.kind == DesignKind::full || design.kind == DesignKind::morris ||
           design.kind == DesignKind::one_at_a_time || (design.kind == DesignKind::sobol && design.indices);
}

std::string dependences(const StudyRows& rows) {
    std::string text;
    const bool all_done = std::all_of(rows.results.begin(), rows.results.end(),
                                      [](const RowResult& result) { return is_done(result.state); });
    for (std::size_t k = 0; k < rows.plan.measures.size(); ++k) {
        const Measure& measure = rows.plan.measures[k];
        const bool has_all =
            std::all_of(rows.results.begin(), rows.results.end(),
                        [&](const RowResult& result) { return result.measures[k].has_value(); });
        text += "<h3>" + xml_escaped(measure_heading(measure)) + "</h3>\n" +
                html_table(spread_table(rows, measure.name));
        if (all_done && has_all && tells_sensitivity(rows.plan.design)) {
            const SensitivityStudy study = study_sensitivity(rows, measure.name);
            text += html_table(study.table) + image(draw_sensitivity(study), study.kind);
        }
    }
    return text;
}

}  // namespace

std::string report_page(const StudyRows& rows, const std::string& title) {
    const bool any_done = std::any_of(rows.results.begin(), rows.results.end(),
                                      [](const RowResult& result) { return is_done(result.state); });
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                       xml_escaped(title) + "</title><style>" + style + "</style></head><body>\n<h1>" +
                       xml_escaped(title) + "</h1>\n<h2>Plan</h2>\n" + html_table(factors_table(rows.plan)) +
                       "<h2>Rows</h2>\n" + html_table(counts_table(rows)) + "<h2>Measures</h2>\n" +
                       html_table(measures_table(rows));
    if (any_done && !rows.plan.fragilities.empty()) page += "<h2>Fragility</h2>\n" + curves(rows);
    if (any_done) page += "<h2>What the measures depend on</h2>\n" + dependences(rows);
    return page + "</body></html>\n";
}

}  // namespace rockslope::study
