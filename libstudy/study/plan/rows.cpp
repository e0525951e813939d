#include "study/plan/rows.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "study/design/unit_points.hpp"

namespace rockslope::study {

namespace {

constexpr double most_combinations = 1e7;
/// Quantiles of a distribution at which one-at-a-time designs take it.
constexpr double low_quantile = 0.05, high_quantile = 0.95;

std::string number_text(double value, const std::string& unit) {
    std::string text = shortest_text(value);
    if (!unit.empty()) return "\"" + text + " " + unit + "\"";
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

/// A row under construction.
class RowMaker {
  public:
    explicit RowMaker(const Plan& plan) : plan_(plan) {
        row_.values.resize(plan.factors.size());
        row_.levels.assign(plan.factors.size(), -1);
    }
    /// Sets a factor, and those paired with it, to a value of its list.
    void set_level(std::size_t factor, int level) {
        for (std::size_t k = 0; k < plan_.factors.size(); ++k) {
            if (k != factor && plan_.factors[k].paired_with != plan_.factors[factor].name) continue;
            row_.levels[k] = level;
            row_.values[k] = plan_.factors[k].values[static_cast<std::size_t>(level)];
        }
    }
    /// Sets a factor by a coordinate in [0, 1): the quantile of its distribution, or a value of its list.
    void set_share(std::size_t factor, double share) {
        const Factor& f = plan_.factors[factor];
        if (f.distribution) {
            row_.levels[factor] = -1;
            row_.values[factor] = number_text(f.distribution->quantile(std::max(share, 0x1p-54)), f.unit);
            return;
        }
        const int count = static_cast<int>(f.values.size());
        set_level(factor, std::min(static_cast<int>(share * count), count - 1));
    }
    Row& row() { return row_; }

  private:
    const Plan& plan_;
    Row row_;
};

/// All combinations of the values of some factors, the last varying fastest.
std::vector<Row> combinations(const Plan& plan, const std::vector<std::size_t>& factors) {
    double count = 1;
    for (const std::size_t factor : factors) count *= static_cast<double>(plan.factors[factor].values.size());
    if (count * plan.replicates > most_combinations)
        throw InputError({plan.file.string()}, "the design has " + shortest_text(count) + " rows",
                         "at most ten million; sampled designs take fewer");
    std::vector<Row> rows;
    std::vector<int> levels(factors.size(), 0);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        RowMaker maker(plan);
        for (std::size_t i = 0; i < factors.size(); ++i) maker.set_level(factors[i], levels[i]);
        rows.push_back(maker.row());
        for (std::size_t i = factors.size(); i-- > 0;) {
            if (++levels[i] < static_cast<int>(plan.factors[factors[i]].values.size())) break;
            levels[i] = 0;
        }
    }
    return rows;
}

/// Each combination of the other factors with all intensities, smallest first.
std::vector<Row> incremental_rows(const Plan& plan) {
    const std::size_t intensity = plan.index_of(plan.design.intensity);
    std::vector<std::size_t> others = independent_factors(plan);
    std::erase(others, intensity);
    others.push_back(intensity);
    std::vector<Row> rows = combinations(plan, others);
    const std::size_t length = plan.factors[intensity].values.size();
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].block = std::to_string(k / length + 1);
        rows[k].place = rows[k].levels[intensity];
        if (rows[k].place > 0) rows[k].previous = static_cast<int>(k) - 1;
    }
    return rows;
}

UnitPoints points_of(const Design& design, int factors) {
    switch (design.kind) {
        case DesignKind::latin_hypercube:
            return latin_hypercube_points(design.samples, factors, design.seed);
        case DesignKind::sobol:
            return design.indices ? saltelli_points(design.samples, factors)
                                  : sobol_points(design.samples, factors);
        case DesignKind::morris:
            return morris_points(design.samples, design.levels, factors, design.seed);
        default:
            return monte_carlo_points(design.samples, factors, design.seed);
    }
}

/// Says to which part of its design a row belongs.
void mark_block(const Plan& plan, const std::vector<std::size_t>& factors, std::size_t number, Row& row) {
    const Design& design = plan.design;
    if (design.kind == DesignKind::morris) {
        const std::size_t length = factors.size() + 1;
        row.block = std::to_string(number / length + 1);
        row.place = static_cast<int>(number % length);
    }
    if (design.kind == DesignKind::sobol && design.indices) {
        const auto base = static_cast<std::size_t>(design.samples);
        const std::size_t block = number / base;
        row.block = block == 0 ? "A" : block == 1 ? "B" : plan.factors[factors[block - 2]].name;
        row.place = static_cast<int>(number % base);
    }
}

std::vector<Row> sampled_rows(const Plan& plan) {
    const std::vector<std::size_t> factors = independent_factors(plan);
    if (factors.empty()) return combinations(plan, factors);
    const UnitPoints points = points_of(plan.design, static_cast<int>(factors.size()));
    std::vector<Row> rows;
    for (std::size_t k = 0; k < points.size(); ++k) {
        RowMaker maker(plan);
        for (std::size_t i = 0; i < factors.size(); ++i) maker.set_share(factors[i], points[k][i]);
        mark_block(plan, factors, k, maker.row());
        rows.push_back(maker.row());
    }
    return rows;
}

/// The middle of all factors, then each at its two ends.
std::vector<Row> one_at_a_time_rows(const Plan& plan) {
    const std::vector<std::size_t> factors = independent_factors(plan);
    RowMaker base(plan);
    for (const std::size_t factor : factors) base.set_share(factor, 0.5);
    base.row().block = "base";
    std::vector<Row> rows = {base.row()};
    for (const std::size_t factor : factors)
        for (const bool is_high : {false, true}) {
            RowMaker maker = base;
            const Factor& f = plan.factors[factor];
            if (f.distribution)
                maker.set_share(factor, is_high ? high_quantile : low_quantile);
            else
                maker.set_level(factor, is_high ? static_cast<int>(f.values.size()) - 1 : 0);
            maker.row().block = f.name;
            maker.row().place = is_high ? 1 : 0;
            rows.push_back(maker.row());
        }
    return rows;
}

std::vector<Row> rows_without_replicates(const Plan& plan) {
    switch (plan.design.kind) {
        case DesignKind::full:
            return combinations(plan, independent_factors(plan));
        case DesignKind::incremental:
            return incremental_rows(plan);
        case DesignKind::one_at_a_time:
            return one_at_a_time_rows(plan);
        default:
            return sampled_rows(plan);
    }
}

}  // namespace

std::vector<std::size_t> independent_factors(const Plan& plan) {
    std::vector<std::size_t> factors;
    for (std::size_t k = 0; k < plan.factors.size(); ++k)
        if (plan.factors[k].paired_with.empty()) factors.push_back(k);
    return factors;
}

std::vector<Row> make_rows(const Plan& plan) {
    std::vector<Row> rows;
    for (Row& row : rows_without_replicates(plan)) {
        const int previous = row.previous;
        for (int replicate = 0; replicate < plan.replicates; ++replicate) {
            row.replicate = replicate;
            row.previous = previous < 0 ? -1 : previous * plan.replicates + replicate;
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace rockslope::study
