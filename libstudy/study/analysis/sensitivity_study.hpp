#pragma once

#include <string>
#include <vector>

#include "study/csv/csv_text.hpp"
#include "study/table/study_table.hpp"

namespace rockslope::study {

/// What a measure depends on, by the design of the study.
struct SensitivityStudy {
    std::string measure_heading;
    std::string kind;          ///< of the figures, for a title: "Sobol' indices", ...
    TextTable table;           ///< one row a factor, the most important first
    std::size_t left_out = 0;  ///< rows, or whole groups of rows, without a value

    /// A bar of a picture: a factor, and one or two values. Of a tornado, the measure at the low and the high
    /// end of the factor; otherwise from zero.
    struct Bar {
        std::string factor;
        double low = 0, high = 0;
        double from = 0;  ///< where the bars begin
    };
    std::vector<Bar> bars;
    std::string low_title, high_title;  ///< of the two values of a bar
};

/// Sobol' indices of a Saltelli or a full design, Morris's elementary effects, or the tornado of one at a
/// time. @throws InputError for an unknown measure, a design that allows none of these, and one with rows
/// missing that it needs.
SensitivityStudy study_sensitivity(const StudyRows& rows, const std::string& measure);

/// How much a measure varies: for each factor, and for the replicates, the standard deviation of its natural
/// logarithm over rows that differ in nothing else, pooled over all such sets; with their number.
TextTable spread_table(const StudyRows& rows, const std::string& measure);

}  // namespace rockslope::study
