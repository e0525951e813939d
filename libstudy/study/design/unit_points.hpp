#pragma once

#include <cstdint>
#include <vector>

namespace rockslope::study {

/// Rows of points of the unit cube [0, 1)^k. Equal arguments give equal points on every platform.
using UnitPoints = std::vector<std::vector<double>>;

/// Independent uniform points. More rows keep the first ones.
UnitPoints monte_carlo_points(int rows, int factors, std::uint64_t seed);

/// One point in each of `rows` equal intervals of every coordinate [mckay1979], at a random place in it.
UnitPoints latin_hypercube_points(int rows, int factors, std::uint64_t seed);

/// The first points of Sobol's sequence, with the direction numbers of Joe and Kuo. More rows keep the first
/// ones.
UnitPoints sobol_points(int rows, int factors);

/// The design of Sobol' indices [saltelli2010], block after block: A, B, and for each factor A with that
/// column of B; A and B from Sobol's sequence. @return (factors + 2) * base_rows rows.
UnitPoints saltelli_points(int base_rows, int factors);

/// Trajectories of Morris [morris1991]: from a random point of a grid of `levels` levels, one step of levels
/// / 2 of them in each factor, in random order. @param levels even. @return (factors + 1) * trajectories
/// rows.
UnitPoints morris_points(int trajectories, int levels, int factors, std::uint64_t seed);

}  // namespace rockslope::study
