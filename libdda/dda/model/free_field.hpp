#pragma once

#include <span>
#include <string>
#include <vector>

#include "dda/model/face.hpp"

namespace rockslope::dda {

struct Model;

/// Free field: a one-dimensional column of rock beside the model in which waves travel vertically. It moves
/// as the rock far from the model does. Each layer lies between two nodes and has the rock of the face
/// beside it.
struct FreeField {
    std::string base_boundary;     ///< viscous boundary whose incident waves enter at the column's base
    std::vector<double> nodes;     ///< m, heights, increasing
    std::vector<BlockIndex> rock;  ///< per layer, the block beside it

    std::size_t layers() const { return rock.size(); }
};

/// The free field beside upright faces that follow each other without gaps.
/// @param layer m, largest height of a layer; 0: one layer per face.
/// @throws std::invalid_argument that names the defect of the faces.
FreeField make_free_field(const Model& model, std::span<const FacePart> faces,
                          const std::string& base_boundary, double layer);

}  // namespace rockslope::dda
