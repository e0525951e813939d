#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/config/config_table.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A part of a face that lies on a line, and where along the line.
struct FaceAlongLine {
    FacePart face;
    double start = 0;  ///< m along the line, where face.from lies
    double end = 0;    ///< m along the line, where face.to lies; below `start` where the edge runs backwards
};

/// The free faces, of blocks that can move, that lie on a line of the initial configuration: within
/// `tolerance` of one of its segments over a length of more than that. Faces of joints do not count, unless
/// `block` asks for one block's faces whatever they are.
std::vector<FaceAlongLine> faces_along_line(const Model& model, std::span<const Vec2> line, double tolerance,
                                            std::optional<int> block = std::nullopt);

/// The line `along` of a table, the faces on it, and what that takes: `tolerance`, and `block` or `at`.
struct FacesAlongLine {
    std::vector<FaceAlongLine> faces;
    double length = 0;  ///< m, of the line
};
/// @throws InputError for a line of less than two different points, or where no face lies.
FacesAlongLine read_faces(const ConfigTable& table, const Model& model);

}  // namespace rockslope::dda
