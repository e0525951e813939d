#include "study/analysis/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "study/table/study_table.hpp"

namespace rockslope::study {

namespace {

std::size_t column_of(const TextTable& table, const std::string& table_name, const std::string& name) {
    if (const auto found = table.find(name)) return *found;
    std::vector<std::string> names;
    for (const std::string& heading : table.heading) names.push_back(heading.substr(0, heading.find(" (")));
    const auto nearest = nearest_word(name, names);
    throw InputError(
        {table_name, 1}, "there is no column '" + name + "'",
        nearest ? "perhaps '" + *nearest + "'" : "the name of a column, with or without its unit");
}

/// Whether a state of a row says nothing of its slope.
bool has_no_result(const std::string& status) {
    return status != state_name(RowState::completed) && status != state_name(RowState::collapsed) &&
           status != state_name(RowState::not_needed);
}

/// Rows of equal intensity and outcome together, with their weights.
std::vector<Outcome> outcomes_of(const std::vector<FragilityPoint>& points, std::span<const double> weights) {
    std::map<double, Outcome> by_intensity;
    for (std::size_t k = 0; k < points.size(); ++k) {
        Outcome& outcome = by_intensity[points[k].intensity];
        outcome.intensity = points[k].intensity;
        (points[k].has_failed ? outcome.failed : outcome.safe) += weights[k];
    }
    std::vector<Outcome> outcomes;
    for (const auto& [intensity, outcome] : by_intensity)
        if (outcome.failed + outcome.safe > 0) outcomes.push_back(outcome);
    return outcomes;
}

std::vector<Demand> demands_of(const std::vector<FragilityPoint>& points, std::span<const double> weights) {
    // A slope that has not moved has no logarithm: it has moved less than the least that others did.
    double least = std::numeric_limits<double>::infinity();
    for (const FragilityPoint& point : points)
        if (point.demand > 0) least = std::min(least, point.demand);
    std::vector<Demand> demands;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const FragilityPoint& point = points[k];
        if (point.demand > 0)
            demands.push_back({point.intensity, point.demand, point.known, weights[k]});
        else if (std::isfinite(least))
            demands.push_back({point.intensity, least, Known::at_most, weights[k]});
    }
    return demands;
}

std::optional<LognormalCurve> curve_of(const std::vector<FragilityPoint>& points,
                                       const FragilityRequest& request, std::span<const double> weights) {
    if (request.method == FragilityMethod::demands) {
        const auto fit = fit_demands(demands_of(points, weights));
        return fit ? fit->curve(request.limit) : std::nullopt;
    }
    const OutcomeFit fit = fit_outcomes(outcomes_of(points, weights));
    return fit.kind == FitKind::curve ? std::optional(fit.curve) : std::nullopt;
}

std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::size_t failed_count(const Fragility& fragility) {
    return static_cast<std::size_t>(std::count_if(fragility.points.begin(), fragility.points.end(),
                                                  [](const auto& point) { return point.has_failed; }));
}

std::pair<double, double> intensity_range(const Fragility& fragility) {
    const auto [low, high] =
        std::minmax_element(fragility.points.begin(), fragility.points.end(),
                            [](const auto& a, const auto& b) { return a.intensity < b.intensity; });
    return {low->intensity, high->intensity};
}

std::string percent(double share) {
    return figure(100 * share) + " %";
}

/// What can be said where there is no curve.
std::string bound_text(const Fragility& fragility) {
    const auto [low, high] = intensity_range(fragility);
    const auto rows = static_cast<double>(fragility.points.size());
    const double confidence = fragility.request.bootstrap.confidence;
    const std::string bound = figure(bound_without_failure(rows, confidence));
    switch (fragility.outcomes.kind) {
        case FitKind::all_safe:
            return "no row failed: the median is above " + figure(high) + ", the largest intensity. With " +
                   percent(confidence) +
                   " confidence the probability of failure over these intensities is below " + bound +
                   ", if the rows are independent";
        case FitKind::all_failed:
            return "every row failed: the median is below " + figure(low) +
                   ", the smallest intensity. With " + percent(confidence) +
                   " confidence the probability of standing over these intensities is below " + bound +
                   ", if the rows are independent";
        case FitKind::separable:
            return "the outcomes are separable: none fails below " +
                   figure(fragility.outcomes.lowest_failed) + ", none stands above " +
                   figure(fragility.outcomes.highest_safe) +
                   ": the median is between them, and the dispersion cannot be told; more rows between them "
                   "can tell it";
        case FitKind::not_increasing:
            return "rows of higher intensity do not fail more often: there is no fragility curve by this "
                   "intensity";
        default:
            return "the demands do not allow a regression: they need three different ones that grow with the "
                   "intensity";
    }
}

std::string band_text(const Fragility& fragility) {
    if (!fragility.band)
        return "no band: fewer than half of the bootstrap samples allow a curve, or there are fewer than two "
               "groups\n";
    std::string text =
        "bands of " + percent(fragility.request.bootstrap.confidence) + " by the bootstrap over ";
    if (fragility.groupings.empty()) text += "rows";
    for (std::size_t k = 0; k < fragility.groupings.size(); ++k)
        text += (k == 0 ? "" : " and ") + std::to_string(fragility.groupings[k].count) + " groups of " +
                fragility.groupings[k].name;
    if (fragility.band->fitted_share < 1)
        text += "; " + percent(fragility.band->fitted_share) + " of the samples allow a curve";
    return text + "\n";
}

std::string with_band(double value, double factor, bool has_band) {
    return figure(value) +
           (has_band ? " (" + figure(value / factor) + " to " + figure(value * factor) + ")" : "");
}

}  // namespace

std::vector<FragilityPoint> fragility_points(const TextTable& table, const std::string& table_name,
                                             const FragilityRequest& request, Fragility& into) {
    const std::size_t measure = column_of(table, table_name, request.measure);
    const std::size_t intensity = column_of(table, table_name, request.intensity);
    const auto status = table.find(status_heading);
    std::vector<std::size_t> groups;
    for (const std::string& group : request.groups) groups.push_back(column_of(table, table_name, group));
    into.measure_heading = table.heading[measure];
    into.intensity_heading = table.heading[intensity];
    std::vector<FragilityPoint> points;
    for (const std::vector<std::string>& row : table.rows) {
        const std::string state = status ? row[*status] : state_name(RowState::completed);
        const auto im = parse_number(row[intensity]), demand = parse_number(row[measure]);
        const bool is_known_to_fail =
            state == state_name(RowState::collapsed) || state == state_name(RowState::not_needed);
        if (has_no_result(state) || !im || !(*im > 0) || (!demand && !is_known_to_fail)) {
            ++into.left_out;
            continue;
        }
        FragilityPoint point;
        point.intensity = *im;
        point.demand = std::abs(demand.value_or(0));
        point.has_failed = is_known_to_fail || point.demand > request.limit;
        if (is_known_to_fail) {
            point.known = Known::at_least;
            point.demand = std::max(point.demand, request.limit);
        }
        for (const std::size_t group : groups) point.groups.push_back(row[group]);
        points.push_back(std::move(point));
    }
    if (points.empty())
        throw InputError(
            {table_name},
            "has no row with a result, '" + into.measure_heading + "' and '" + into.intensity_heading + "'",
            "rows that are done: make, then dda-study collect");
    return points;
}

std::vector<std::string> fragility_groups(const Plan& plan) {
    std::vector<std::string> groups;
    for (const Factor& factor : plan.factors) {
        const bool is_record = !factor.files.empty();
        const bool is_realisation =
            !factor.targets.empty() && factor.targets.front().file == ModelFile::slope;
        if ((is_record || is_realisation) && groups.size() < 2) groups.push_back(factor.name);
    }
    return groups;
}

Fragility fit_points(const Fragility& whole, std::vector<FragilityPoint> points) {
    Fragility fragility = whole;
    fragility.points = std::move(points);
    fragility.groupings.clear();
    const std::vector<double> once(fragility.points.size(), 1.0);
    fragility.outcomes = fit_outcomes(outcomes_of(fragility.points, once));
    if (fragility.request.method == FragilityMethod::demands)
        fragility.demands = fit_demands(demands_of(fragility.points, once));
    fragility.curve = curve_of(fragility.points, fragility.request, once);
    fragility.band.reset();
    for (std::size_t k = 0; k < fragility.request.groups.size(); ++k) {
        std::vector<std::string> labels;
        for (const FragilityPoint& point : fragility.points) labels.push_back(point.groups[k]);
        const Grouping grouping = group_by(fragility.request.groups[k], labels);
        if (grouping.count > 1) fragility.groupings.push_back(grouping);
    }
    if (fragility.curve)
        fragility.band = bootstrap(
            [&](std::span<const double> weights) {
                return curve_of(fragility.points, fragility.request, weights);
            },
            fragility.points.size(), fragility.groupings, fragility.request.bootstrap);
    return fragility;
}

Fragility fit_fragility(const TextTable& table, const std::string& table_name,
                        const FragilityRequest& request) {
    Fragility fragility;
    fragility.request = request;
    std::vector<FragilityPoint> points = fragility_points(table, table_name, request, fragility);
    return fit_points(fragility, std::move(points));
}

std::string fragility_text(const Fragility& fragility) {
    const std::size_t failed = failed_count(fragility);
    std::string text = "P(" + fragility.measure_heading + " > " + figure(fragility.request.limit) + " | " +
                       fragility.intensity_heading + "): " + std::to_string(fragility.points.size()) +
                       " rows, " + std::to_string(failed) + " beyond the limit";
    if (fragility.left_out > 0)
        text += ", " + std::to_string(fragility.left_out) + " without a result are left out";
    text += "\n";
    if (!fragility.curve) return text + bound_text(fragility) + "\n";
    const bool has_band = fragility.band.has_value();
    text +=
        "median " +
        with_band(fragility.curve->median, has_band ? fragility.band->median_factor() : 1, has_band) +
        ", dispersion " +
        with_band(fragility.curve->dispersion, has_band ? fragility.band->dispersion_factor() : 1, has_band) +
        "\n";
    if (fragility.demands) {
        const DemandFit& fit = *fragility.demands;
        text += "ln D = " + figure(fit.intercept) + (fit.slope < 0 ? " - " : " + ") +
                figure(std::abs(fit.slope)) + " ln IM, sigma " + figure(fit.sigma) +
                ", of greatest likelihood " + figure(fit.sigma_likeliest) +
                ", -ln L = " + figure(-fit.log_likelihood) + "\n";
    } else {
        char likelihood[48];
        std::snprintf(likelihood, sizeof likelihood, "-ln L = %.9g\n", -fragility.outcomes.log_likelihood);
        text += likelihood;
    }
    return text + band_text(fragility);
}

TextTable fragility_table(const Fragility& fragility) {
    constexpr int points = 100;
    TextTable table;
    table.heading = {fragility.intensity_heading, "probability of failure", "lower", "upper"};
    const auto [low, high] = intensity_range(fragility);
    if (!fragility.curve) {
        const std::string bound = shortest_text(bound_without_failure(
            static_cast<double>(fragility.points.size()), fragility.request.bootstrap.confidence));
        if (fragility.outcomes.kind == FitKind::all_safe)
            table.rows.push_back({shortest_text(high), "", "0", bound});
        if (fragility.outcomes.kind == FitKind::all_failed)
            table.rows.push_back({shortest_text(low), "", shortest_text(1 - *parse_number(bound)), "1"});
        if (fragility.outcomes.kind == FitKind::separable) {
            table.rows.push_back({shortest_text(fragility.outcomes.highest_safe), "0", "", ""});
            table.rows.push_back({shortest_text(fragility.outcomes.lowest_failed), "1", "", ""});
        }
        return table;
    }
    for (int k = 0; k <= points; ++k) {
        const double intensity = low / 2 * std::pow(4 * high / low, k / static_cast<double>(points));
        std::vector<std::string> row = {shortest_text(intensity),
                                        shortest_text(fragility.curve->probability(intensity)), "", ""};
        if (fragility.band) {
            const auto [lower, upper] = fragility.band->probability(intensity);
            row[2] = shortest_text(lower);
            row[3] = shortest_text(upper);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

TextTable convergence_table(const Fragility& fragility) {
    TextTable table;
    table.heading = {"groups", "median", "lower", "upper", "rows"};
    if (fragility.groupings.empty()) return table;
    const Grouping& grouping = fragility.groupings.front();
    for (int count = 2; count <= grouping.count; ++count) {
        std::vector<FragilityPoint> points;
        for (std::size_t k = 0; k < fragility.points.size(); ++k)
            if (grouping.group_of[k] < count) points.push_back(fragility.points[k]);
        const std::size_t rows = points.size();
        const Fragility part = fit_points(fragility, std::move(points));
        std::vector<std::string> row = {std::to_string(count), "", "", "", std::to_string(rows)};
        if (part.curve) row[1] = shortest_text(part.curve->median);
        if (part.band) {
            row[2] = shortest_text(part.curve->median / part.band->median_factor());
            row[3] = shortest_text(part.curve->median * part.band->median_factor());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace rockslope::study
