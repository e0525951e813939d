#pragma once

#include <span>
#include <vector>

namespace rockslope::study {

/// Share of an output's variance that one factor explains alone, and in all its interactions.
struct SensitivityIndex {
    double first = 0;        ///< first-order index
    double total = 0;        ///< total index
    double first_error = 0;  ///< standard error, by the bootstrap; 0: not estimated
    double total_error = 0;
};

/// Sobol' indices of a Saltelli design: outputs of A, of B, and for each factor of A with that column of B,
/// one value for each base row. First-order by [saltelli2010], total by [jansen1999]. Without variance all
/// are zero.
/// @param mixed per factor, as many values as `a`.
std::vector<SensitivityIndex> sobol_indices(std::span<const double> a, std::span<const double> b,
                                            const std::vector<std::vector<double>>& mixed);

/// The same indices of a full design, exactly, from the means over all other factors: first order by the
/// variance of the mean for each level, total by one less that of the means without the factor.
/// @param levels per factor and row, the level from 0; @param values per row.
std::vector<SensitivityIndex> factorial_indices(const std::vector<std::vector<int>>& levels,
                                                std::span<const double> values);

/// Morris's elementary effects of a factor: the mean of their absolute values, which ranks factors, the mean
/// and the standard deviation, which is large where the effect depends on the others [morris1991].
struct ElementaryEffects {
    double mean_absolute = 0, mean = 0, deviation = 0;
    int count = 0;
};
/// @param effects per factor: differences of the output over the step of the factor.
std::vector<ElementaryEffects> summarise_effects(const std::vector<std::vector<double>>& effects);

}  // namespace rockslope::study
