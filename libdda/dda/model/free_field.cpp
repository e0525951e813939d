#include "dda/model/free_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dda/model/model.hpp"

namespace rockslope::dda {

namespace {

constexpr double upright = 1e-3;        // largest width of an upright face over its height
constexpr double max_gap_ratio = 1e-3;  // largest gap between faces over their height
constexpr double max_layers = 1e5;      // per face

/// Heights between which a face lies, m, and its block.
struct FacePiece {
    double from = 0, to = 0;
    BlockIndex block;
};

FacePiece face_piece_of(const Model& model, const FacePart& face) {
    const Topology& topology = model.topology;
    const Vec2& first = model.vertices[start_of(face.edge)];
    const Vec2 along = model.vertices[topology.end_of(face.edge)] - first;
    if (std::abs(along.x()) > upright * std::abs(along.y()))
        throw std::invalid_argument("a face beside it is not upright");
    const double a = first.y() + face.from * along.y(), b = first.y() + face.to * along.y();
    return {std::min(a, b), std::max(a, b), topology.block_of_edge(face.edge)};
}

}  // namespace

FreeField make_free_field(const Model& model, std::span<const FacePart> faces,
                          const std::string& base_boundary, double layer) {
    std::vector<FacePiece> pieces;
    for (const FacePart& face : faces) pieces.push_back(face_piece_of(model, face));
    if (pieces.empty()) throw std::invalid_argument("there is no face beside it");
    std::sort(pieces.begin(), pieces.end(),
              [](const FacePiece& a, const FacePiece& b) { return a.from < b.from; });
    FreeField field{base_boundary, {pieces.front().from}, {}};
    for (const FacePiece& piece : pieces) {
        const double height = piece.to - piece.from;
        if (std::abs(piece.from - field.nodes.back()) > max_gap_ratio * height)
            throw std::invalid_argument("the faces beside it do not follow each other");
        const double layer_count = layer > 0 ? std::ceil(height / layer * (1 - 1e-9)) : 1;
        if (!(layer_count <= max_layers)) throw std::invalid_argument("its layers are too thin");
        const int count = std::max(1, static_cast<int>(layer_count));
        for (int k = 1; k <= count; ++k) {
            field.nodes.push_back(piece.from + height * k / count);
            field.rock.push_back(piece.block);
        }
    }
    return field;
}

}  // namespace rockslope::dda
