#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/plan/plan.hpp"

namespace rockslope::study {

/// One run of a study.
struct Row {
    std::vector<std::string> values;  ///< per factor, TOML
    std::vector<int> levels;          ///< per factor, index of its value; -1: drawn from a distribution
    int replicate = 0;                ///< 0: unperturbed
    /// The part of a design that the row belongs to: "A", "B", or the name of the factor whose column of B is
    /// in A; the number of Morris's trajectory; of one at a time, the factor that is changed; incremental,
    /// the number of the record and its realisation, whose rows differ in the intensity. Empty otherwise.
    std::string block;
    int place = 0;      ///< within its block, from 0
    int previous = -1;  ///< incremental: index of the row of the next smaller intensity
};

/// The factors that vary by themselves, as indices; the paired ones go with them.
std::vector<std::size_t> independent_factors(const Plan& plan);

/// The rows of a plan, in the order of the design; the replicates of a row follow each other.
/// @throws InputError for more than ten million rows.
std::vector<Row> make_rows(const Plan& plan);

}  // namespace rockslope::study
