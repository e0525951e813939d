#pragma once

#include <span>
#include <string>
#include <vector>

#include "dda/model/face.hpp"

namespace rockslope::dda {

struct Model;

/// A column of rock beside the model, as wide as one likes, in which waves only climb: what the rock far away
/// does. Layers lie between nodes and have the rock of the faces beside them.
struct FreeField {
    std::string base_boundary;  ///< viscous boundary whose incident waves enter at the column's foot
    std::vector<double> nodes;  ///< m, heights, increasing
    std::vector<int> rock;      ///< per layer, the block beside it

    std::size_t layers() const { return rock.size(); }
};

/// The column beside upright faces that follow each other without gaps. @param layer m, the largest height of
/// a layer; 0: one for each face. @throws std::invalid_argument, which says what is wrong with the faces.
FreeField make_free_field(const Model& model, std::span<const FacePart> faces,
                          const std::string& base_boundary, double layer);

}  // namespace rockslope::dda
