#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/config/config_table.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A part of a face that lies on a line, and its position along the line.
struct FaceAlongLine {
    FacePart face;
    double start = 0;  ///< m along the line, of face.from
    double end = 0;    ///< m along the line, of face.to; below `start` if the edge runs backwards
};

/// The faces of free blocks that lie on a line of the initial configuration: within `tolerance`, m, of one of
/// its segments over more than that length. Joint faces are included only if `block` selects a block.
std::vector<FaceAlongLine> faces_along_line(const Model& model, std::span<const Vec2> line, double tolerance,
                                            std::optional<BlockIndex> block = std::nullopt);

/// The faces on the line `along` of a table. Optional keys: `tolerance`, and `block` or `at`.
struct FacesAlongLine {
    std::vector<FaceAlongLine> faces;
    double length = 0;  ///< m, of the line
};
/// @throws InputError for a line of fewer than two different points, or without a face on it.
FacesAlongLine read_faces(const ConfigTable& table, const Model& model);

}  // namespace rockslope::dda
