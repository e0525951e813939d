#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/fit/mapped_pieces.hpp"
#include "blockgen/input/distribution.hpp"

namespace rockslope::blockgen {

/// A map of joints: its traces, and what was mapped. Coordinates in m.
struct JointMap {
    std::vector<Trace> traces;
    MapWindow window;
};

/// An estimate, and the interval that holds the truth in nine cases of ten.
struct Estimate {
    double value = 0, low = 0, high = 0;
};

/// How the joints of a set lie in the map.
enum class SetPattern {
    anywhere,  ///< independent traces with ends
    through,   ///< joints that cross the whole map
    on_lines   ///< several traces on one line, with rock bridges between them
};

/// A set of joints of a map. Angles in rad, lengths in m.
struct FittedSet {
    std::string name;
    SetPattern pattern = SetPattern::anywhere;
    std::size_t pieces = 0;             ///< pieces of traces in the map
    std::size_t cut = 0;                ///< ends that the map's edge cut off
    Estimate direction;                 ///< of the mean
    Estimate scatter;                   ///< standard deviation about it
    std::optional<Estimate> length;     ///< mean length of traces; absent where they cross the map
    std::optional<Estimate> length_sd;  ///< present for a lognormal law
    Law length_law = Law::exponential;
    Estimate p20;      ///< 1/m2, traces per area, each counted at its middle; 0 where they cross the map
    Estimate p21;      ///< 1/m, length per area
    Estimate spacing;  ///< m: of lines across the mean direction; of traces anywhere 1/P10
    std::optional<Estimate> spacing_sd;   ///< of lines
    Law spacing_law = Law::exponential;   ///< of lines
    std::optional<Estimate> persistence;  ///< jointed share of the lines
};

struct MapFit {
    std::vector<FittedSet> sets;  ///< by descending number of pieces
    double area = 0;              ///< of the map, m2
    std::vector<std::string> notes;
};

struct FitOptions {
    std::size_t sets = 0;  ///< number of sets; 0: estimated
    double edge = 0;  ///< m: ends that near to the edge of the map are cut off there; 0: 5e-4 of its size
    std::uint64_t seed = 0;  ///< of the resampling behind the intervals
};

/// Estimates sets, lengths, spacing and intensity of joints from a map. Lengths per area are unbiased
/// whatever the window cuts off; the number of traces per area is half that of their ends; the mean length is
/// the ratio (Mauldon 1998). Intervals are percentiles of Poisson-weighted resamples of the traces, or of the
/// lines or spacings where traces lie on lines. @throws std::invalid_argument when the window holds no trace.
MapFit fit_map(const JointMap& map, const FitOptions& options);

}  // namespace rockslope::blockgen
