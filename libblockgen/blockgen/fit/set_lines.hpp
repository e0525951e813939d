#pragma once

#include <vector>

#include "blockgen/fit/direction_sets.hpp"
#include "blockgen/fit/mapped_pieces.hpp"
#include "blockgen/input/distribution.hpp"

namespace rockslope::blockgen {

/// The lines along which the pieces of a set lie.
struct SetLines {
    std::size_t lines = 0;
    std::vector<std::size_t> line_of;  ///< of each piece
    std::vector<double> chord;         ///< length of each line within the window, m
    /// Distances between neighbouring lines where they cross the line through the middle of the window across
    /// the set's mean direction, m. Where the set's directions scatter, only within the window.
    std::vector<double> gaps;
};

/// Each trace on a line of its own, as those that cross the window are: the pieces of one trace follow each
/// other in the list.
SetLines own_lines(const std::vector<MappedPiece>& pieces, const DirectionSet& direction,
                   const MapWindow& window);

/// Pieces of a set without scatter lie on one line when they are collinear; those of other sets lie on the
/// lines of their traces.
SetLines common_lines(const std::vector<MappedPiece>& pieces, const DirectionSet& direction,
                      const MapWindow& window);

/// The law of distances between lines: constant, exponential or lognormal, by Akaike's criterion.
Law law_of_gaps(const std::vector<double>& gaps);

}  // namespace rockslope::blockgen
