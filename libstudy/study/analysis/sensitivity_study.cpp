#include "study/analysis/sensitivity_study.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "study/folder/study_folder.hpp"
#include "study/plan/rows.hpp"
#include "study/statistics/sensitivity.hpp"

namespace rockslope::study {

namespace {

std::size_t measure_index(const StudyRows& rows, const std::string& measure) {
    std::vector<std::string> names;
    for (const Measure& known : rows.plan.measures) names.push_back(known.name);
    const auto found = std::find(names.begin(), names.end(), measure);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    const auto nearest = nearest_word(measure, names);
    throw InputError({rows.plan.file.string()}, "there is no measure '" + measure + "'",
                     nearest ? "perhaps '" + *nearest + "'" : "the name of a [[measure]]");
}

/// The rows of a design, replicates together: the mean of their values.
struct DesignRow {
    std::vector<std::string> factors;
    std::string block;
    int place = 0;
    std::optional<double> value;
};

std::vector<DesignRow> design_rows(const StudyRows& rows, std::size_t measure) {
    const std::size_t replicate = *rows.runs.find(replicate_column), block = *rows.runs.find(block_column),
                      place = *rows.runs.find(place_column);
    std::vector<DesignRow> design;
    std::size_t values = 0;  // of the present row
    for (std::size_t k = 0; k < rows.runs.rows.size(); ++k) {
        const std::vector<std::string>& run = rows.runs.rows[k];
        if (run[replicate] == "0") {
            DesignRow row;
            for (const std::size_t factor : independent_factors(rows.plan))
                row.factors.push_back(run[factor + 1]);
            row.block = run[block];
            row.place = static_cast<int>(parse_number(run[place]).value_or(0));
            design.push_back(std::move(row));
            values = 0;
        }
        const std::optional<double>& value = rows.results[k].measures[measure];
        if (!value) continue;
        DesignRow& row = design.back();
        row.value =
            (row.value.value_or(0) * static_cast<double>(values) + *value) / static_cast<double>(values + 1);
        ++values;
    }
    return design;
}

[[noreturn]] void fail_for_rows(const StudyRows& rows, const std::string& what) {
    throw InputError({rows.plan.file.string()}, what, "a study whose rows are all done");
}

std::string text_of(double value) {
    return shortest_text(value);
}

void order_by(std::vector<std::pair<double, std::vector<std::string>>>& rows, SensitivityStudy& study) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (auto& [importance, row] : rows) study.table.rows.push_back(std::move(row));
}

void write_indices(const StudyRows& rows, const std::vector<SensitivityIndex>& indices,
                   SensitivityStudy& study) {
    study.low_title = "first order";
    study.high_title = "total";
    study.table.heading = {"factor", "first order", "total", "standard error of the first order",
                           "standard error of the total"};
    const std::vector<std::size_t> factors = independent_factors(rows.plan);
    std::vector<std::pair<double, std::vector<std::string>>> lines;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const SensitivityIndex& index = indices[k];
        const std::string& name = rows.plan.factors[factors[k]].name;
        lines.push_back({index.total,
                         {name, text_of(index.first), text_of(index.total), text_of(index.first_error),
                          text_of(index.total_error)}});
        study.bars.push_back({name, index.first, index.total, 0});
    }
    order_by(lines, study);
}

void saltelli(const StudyRows& rows, const std::vector<DesignRow>& design, SensitivityStudy& study) {
    const std::vector<std::size_t> factors = independent_factors(rows.plan);
    const auto base = static_cast<std::size_t>(rows.plan.design.samples);
    std::vector<double> a, b;
    std::vector<std::vector<double>> mixed(factors.size());
    for (std::size_t k = 0; k < base; ++k) {
        bool is_whole = true;
        for (std::size_t block = 0; block < factors.size() + 2; ++block)
            is_whole = is_whole && design[block * base + k].value;
        if (!is_whole) {
            ++study.left_out;
            continue;
        }
        a.push_back(*design[k].value);
        b.push_back(*design[base + k].value);
        for (std::size_t factor = 0; factor < factors.size(); ++factor)
            mixed[factor].push_back(*design[(factor + 2) * base + k].value);
    }
    if (a.size() < 2) fail_for_rows(rows, "fewer than two base rows of the design are complete");
    study.kind = "Sobol' indices";
    write_indices(rows, sobol_indices(a, b, mixed), study);
}

void factorial(const StudyRows& rows, const std::vector<DesignRow>& design, SensitivityStudy& study) {
    const std::vector<std::size_t> factors = independent_factors(rows.plan);
    std::vector<std::vector<int>> levels(factors.size());
    std::vector<double> values;
    std::vector<std::map<std::string, int>> known(factors.size());
    for (const DesignRow& row : design) {
        if (!row.value) fail_for_rows(rows, "a row has no value, and the indices of a full design need all");
        values.push_back(*row.value);
        for (std::size_t k = 0; k < factors.size(); ++k)
            levels[k].push_back(
                known[k].try_emplace(row.factors[k], static_cast<int>(known[k].size())).first->second);
    }
    study.kind = "Sobol' indices of the full design";
    write_indices(rows, factorial_indices(levels, values), study);
}

void morris(const StudyRows& rows, const std::vector<DesignRow>& design, SensitivityStudy& study) {
    const std::vector<std::size_t> factors = independent_factors(rows.plan);
    std::vector<std::vector<double>> effects(factors.size());
    // The step of a factor is half of its range of levels.
    constexpr double step = 0.5;
    for (std::size_t k = 1; k < design.size(); ++k) {
        if (design[k].block != design[k - 1].block) continue;
        if (!design[k].value || !design[k - 1].value) {
            ++study.left_out;
            continue;
        }
        for (std::size_t factor = 0; factor < factors.size(); ++factor)
            if (design[k].factors[factor] != design[k - 1].factors[factor])
                effects[factor].push_back((*design[k].value - *design[k - 1].value) / step);
    }
    study.kind = "elementary effects";
    study.low_title = "mean of absolute effects";
    study.high_title = "standard deviation";
    study.table.heading = {"factor", "mean of absolute effects", "standard deviation of effects",
                           "number of effects"};
    const std::vector<ElementaryEffects> summaries = summarise_effects(effects);
    std::vector<std::pair<double, std::vector<std::string>>> lines;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const std::string& name = rows.plan.factors[factors[k]].name;
        lines.push_back({summaries[k].mean_absolute,
                         {name, text_of(summaries[k].mean_absolute), text_of(summaries[k].deviation),
                          std::to_string(summaries[k].count)}});
        study.bars.push_back({name, summaries[k].mean_absolute, summaries[k].deviation, 0});
    }
    order_by(lines, study);
}

void tornado(const StudyRows& rows, const std::vector<DesignRow>& design, SensitivityStudy& study) {
    study.kind = "one factor at a time";
    study.low_title = "low end";
    study.high_title = "high end";
    study.table.heading = {"factor", "low", "high", "value at low", "value at high", "swing"};
    if (design.empty() || !design.front().value) fail_for_rows(rows, "the row in the middle has no value");
    const std::vector<std::size_t> factors = independent_factors(rows.plan);
    std::vector<std::pair<double, std::vector<std::string>>> lines;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const DesignRow &low = design[2 * k + 1], &high = design[2 * k + 2];
        if (!low.value || !high.value) {
            ++study.left_out;
            continue;
        }
        const std::string& name = rows.plan.factors[factors[k]].name;
        const double swing = std::abs(*high.value - *low.value);
        lines.push_back({swing,
                         {name, low.factors[k], high.factors[k], text_of(*low.value), text_of(*high.value),
                          text_of(swing)}});
        study.bars.push_back({name, *low.value, *high.value, *design.front().value});
    }
    order_by(lines, study);
}

/// Pooled standard deviation of ln over sets of rows.
struct Pool {
    double squares = 0;
    std::size_t freedom = 0, sets = 0;

    void add(const std::vector<double>& logarithms) {
        if (logarithms.size() < 2) return;
        double mean = 0;
        for (const double value : logarithms) mean += value / static_cast<double>(logarithms.size());
        for (const double value : logarithms) squares += (value - mean) * (value - mean);
        freedom += logarithms.size() - 1;
        ++sets;
    }
};

/// Rows with equal labels in all columns but one form a set.
Pool pooled_spread(const StudyRows& rows, std::size_t measure, std::size_t varied, std::size_t columns) {
    std::map<std::vector<std::string>, std::vector<double>> sets;
    for (std::size_t k = 0; k < rows.runs.rows.size(); ++k) {
        const auto& value = rows.results[k].measures[measure];
        if (!value || !(std::abs(*value) > 0) || rows.results[k].state != RowState::completed) continue;
        std::vector<std::string> key;
        for (std::size_t column = 1; column < columns; ++column)
            if (column != varied) key.push_back(rows.runs.rows[k][column]);
        sets[key].push_back(std::log(std::abs(*value)));
    }
    Pool pool;
    for (const auto& [key, logarithms] : sets) pool.add(logarithms);
    return pool;
}

}  // namespace

SensitivityStudy study_sensitivity(const StudyRows& rows, const std::string& measure) {
    const std::size_t index = measure_index(rows, measure);
    const std::vector<DesignRow> design = design_rows(rows, index);
    SensitivityStudy study;
    study.measure_heading = measure_heading(rows.plan.measures[index]);
    const Design& plan = rows.plan.design;
    if (plan.kind == DesignKind::sobol && plan.indices)
        saltelli(rows, design, study);
    else if (plan.kind == DesignKind::full)
        factorial(rows, design, study);
    else if (plan.kind == DesignKind::morris)
        morris(rows, design, study);
    else if (plan.kind == DesignKind::one_at_a_time)
        tornado(rows, design, study);
    else
        throw InputError({rows.plan.file.string()}, "the design does not tell what a measure depends on",
                         "\"sobol\" with indices = true, \"full\", \"morris\" or \"one-at-a-time\"");
    std::stable_sort(study.bars.begin(), study.bars.end(), [](const auto& a, const auto& b) {
        return std::abs(a.high - a.low) + std::abs(a.high - a.from) >
               std::abs(b.high - b.low) + std::abs(b.high - b.from);
    });
    return study;
}

TextTable spread_table(const StudyRows& rows, const std::string& measure) {
    const std::size_t index = measure_index(rows, measure);
    const std::size_t replicate = *rows.runs.find(replicate_column);
    TextTable table;
    table.heading = {"varied alone", "standard deviation of the logarithm", "sets of rows"};
    for (std::size_t column = 1; column <= replicate; ++column) {
        const Pool pool = pooled_spread(rows, index, column, replicate + 1);
        if (pool.freedom == 0) continue;
        table.rows.push_back({column == replicate ? "replicate (run to run)" : rows.runs.heading[column],
                              shortest_text(std::sqrt(pool.squares / static_cast<double>(pool.freedom))),
                              std::to_string(pool.sets)});
    }
    return table;
}

}  // namespace rockslope::study
