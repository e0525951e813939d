#pragma once

#include <cstddef>
#include <vector>

namespace rockslope::blockgen {

/// The difference of two directions that have no sense, in [-pi/2, pi/2].
double axial_difference(double a, double b);

/// A set of directions that scatter normally about a mean, rad.
struct DirectionSet {
    double share = 1;  ///< of all directions
    double mean = 0;   ///< in (-pi/2, pi/2]
    double sd = 0;
};

/// Directions divided into sets.
struct DirectionSets {
    std::vector<DirectionSet> sets;   ///< by descending share
    std::vector<std::size_t> set_of;  ///< to which each direction most probably belongs
    /// For each set: the probability of each direction to belong to it.
    std::vector<std::vector<double>> probability;
};

/// Divides directions into sets by a mixture of normal distributions of axial angles, which
/// expectation-maximisation fits (Dempster, Laird and Rubin 1977). @param count number of sets; 0: that of
/// the least Bayesian information criterion (Schwarz 1978), at most six. Limitation: sets whose scatter
/// overlaps by more than their means are apart are taken for one.
DirectionSets divide_directions(const std::vector<double>& directions, std::size_t count);

}  // namespace rockslope::blockgen
