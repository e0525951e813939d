#pragma once

#include <optional>

#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// Two blocks that take the same place.
struct Overlap {
    BlockIndex first, second;  ///< first < second
    Point at;                  ///< inside one, inside the other or on its boundary
    double depth = 0;          ///< m, distance of `at` from the boundary of the one that it is inside
};

/// Depth beyond which blocks overlap, over the square root of the smaller one's area. Dimensionless. The
/// corners of blocks that touch are rounded to the cutter's grid, 1e-6 m, or by a user to a few digits.
inline constexpr double overlap_share = 1e-3;

/// The first pair of blocks, by number, of which a part of one's boundary, or the whole block, lies inside
/// the other by more than overlap_share; nothing where there is none. A block in another one's hole does not
/// overlap it. Time grows with the number of blocks times that of their neighbours.
std::optional<Overlap> find_overlap(const BlockMesh& mesh);

}  // namespace rockslope::blockgen
