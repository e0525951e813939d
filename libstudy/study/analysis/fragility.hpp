#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/csv/csv_text.hpp"
#include "study/plan/plan.hpp"
#include "study/statistics/fit_demands.hpp"
#include "study/statistics/fit_outcomes.hpp"
#include "study/statistics/resample.hpp"

namespace rockslope::study {

/// How a fragility curve is fitted.
enum class FragilityMethod {
    outcomes,  ///< which rows failed, by maximum likelihood
    demands    ///< regression of ln-demand on ln-intensity; the demand of a collapsed row is a lower bound
};

/// What a fragility curve is asked for.
struct FragilityRequest {
    std::string measure;    ///< column of the demand
    std::string intensity;  ///< column of the intensity
    double limit = 0;       ///< of the demand: a row has failed beyond it, or when it collapsed
    FragilityMethod method = FragilityMethod::outcomes;
    std::vector<std::string> groups;  ///< at most two columns whose rows belong together
    BootstrapOptions bootstrap;
};

/// One row of a study, as a fragility curve sees it.
struct FragilityPoint {
    double intensity = 0;
    double demand = 0;  ///< meaningless where `known` is at_least and the row says none
    Known known = Known::value;
    bool has_failed = false;
    std::vector<std::string> groups;  ///< labels, in the order of the request
};

/// A fragility curve, or what takes its place.
struct Fragility {
    FragilityRequest request;
    std::string measure_heading, intensity_heading;
    std::vector<FragilityPoint> points;
    std::size_t left_out = 0;  ///< rows without a result
    OutcomeFit outcomes;
    std::optional<DemandFit> demands;     ///< with the method `demands`, where the rows allow it
    std::optional<LognormalCurve> curve;  ///< nothing where the rows allow none
    std::optional<CurveBand> band;
    std::vector<Grouping> groupings;  ///< as used for the band
};

/// The rows of a table of results for a curve. @throws InputError for an unknown column, with the nearest
/// name, and for a table without a row that is done.
/// @param table_name for messages.
std::vector<FragilityPoint> fragility_points(const TextTable& table, const std::string& table_name,
                                             const FragilityRequest& request, Fragility& into);

/// Fits the curve of a request to a table of results.
Fragility fit_fragility(const TextTable& table, const std::string& table_name,
                        const FragilityRequest& request);

/// The same curve from the points with some groups only, for the number of groups that is enough.
Fragility fit_points(const Fragility& whole, std::vector<FragilityPoint> points);

/// The columns whose rows belong together in a study: the first factors that choose records or realisations,
/// at most two.
std::vector<std::string> fragility_groups(const Plan& plan);

/// What the fit says, as text: the median and dispersion with their bands, or why there is no curve and what
/// can be said instead.
std::string fragility_text(const Fragility& fragility);

/// Intensity, probability of failure and its band, at intensities between the smallest and the largest; where
/// there is no curve, the bound that takes its place.
TextTable fragility_table(const Fragility& fragility);

/// The median and its band from the first 2, 3, ... groups of the first grouping: how many are enough.
TextTable convergence_table(const Fragility& fragility);

}  // namespace rockslope::study
